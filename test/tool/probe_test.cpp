#include "incision/tool/probe/probe.h"

#include <gtest/gtest.h>

#include "incision/base/input_error.h"
#include "support/blade.h"
#include "support/tool.h"
#include "support/tool_rig.h"

namespace incision {
namespace {

/// The plate and a ball that is pressed into it from above, by a probe or by a blade that is switched off.
struct Pressed {
  explicit Pressed(const KindSettings& kind) : body(scene(kind), loadMesh(scene(kind)), {{toolUrdf(BALL)}, ""}) {}

  void press() {
    body.activateTool(false);
    for (int k = 0; k <= 30; ++k) {
      body.guideTool({poseAt(0.5, 0.25, 0.31 - 0.002 * k)});
      force = body.step().tools[0].force;
    }
  }

  static constexpr const char* BALL = "<sphere radius='0.05'/>";
  static Scene scene(const KindSettings& kind) {
    Scene scene = plateAndBlade();
    scene.tools[0].description = "ball.urdf";
    scene.tools[0].kind = kind;
    scene.contact.emplace();
    scene.boundary = {{Place(Vec3(-1, -1, -1), Vec3(2, 1, 1e-6)), Vec3::Zero()}};
    return scene;
  }

  DeformableBody body;
  Vec3 force = Vec3::Zero();
};

TEST(Probe, IsABladeThatIsSwitchedOff) {
  Pressed probe{ProbeSettings()}, blade{BladeSettings{Edge{Vec3(0, 0, -0.05), Vec3(0, 0, 0.05)}}};
  probe.press();
  blade.press();
  EXPECT_GT(probe.force.z(), 1);
  EXPECT_EQ(probe.force, blade.force);
  EXPECT_EQ(probe.body.stateHash(), blade.body.stateHash());
}

TEST(Probe, CutsNothingWhileItIsActive) {
  Pressed probe{ProbeSettings()};
  probe.press();
  probe.body.activateTool(true);
  for (int k = 0; k <= 20; ++k) {
    probe.body.guideTool({poseAt(0.5 + 0.01 * k, 0.25, 0.25)});
    probe.body.step();
  }
  EXPECT_EQ(probe.body.counts().cracks, 0);
}

TEST(Probe, WithoutAShapeIsRefused) {
  const Scene scene = Pressed::scene(ProbeSettings());
  const std::string bare = "<robot name='tool'><link name='blade'/></robot>";
  EXPECT_THROW(DeformableBody(scene, loadMesh(scene), {{bare}, ""}), InputError);
}

}  // namespace
}  // namespace incision
