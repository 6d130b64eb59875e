#include "incision/scene/live_settings.h"

#include <gtest/gtest.h>

#include "incision/base/input_error.h"
#include "incision/base/yaml_reader.h"
#include "incision/scene/scene.h"

namespace incision {
namespace {

LiveSettings parsed(const std::string& yaml, const LiveSettings& now) {
  return parseLiveSettings(YamlValue(YAML::Load(yaml), "here").map(liveKeys()), now);
}

std::string complaintOfChange(const std::string& yaml) {
  try {
    parsed(yaml, liveSettingsOf(Scene()));
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(LiveSettings, AreAtFirstThoseOfTheScene) {
  Scene scene;
  scene.solver.tolerance = 1e-4;
  scene.solver.threads = 3;
  scene.gravity = Vec3(1, 2, 3);
  const LiveSettings settings = liveSettingsOf(scene);
  EXPECT_EQ(settings, (LiveSettings{1e-4, 3, Vec3(1, 2, 3), 1}));
  EXPECT_EQ(whyInvalid(settings), "");
}

TEST(LiveSettings, ChangeInWhatIsSaidAlone) {
  const LiveSettings now = {1e-4, 3, Vec3(1, 2, 3), 2};
  EXPECT_EQ(parsed("{}", now), now);
  EXPECT_EQ(parsed("{tolerance: 1e-3, gravity_z: -1.6}", now), (LiveSettings{1e-3, 3, Vec3(1, 2, -1.6), 2}));
  EXPECT_EQ(parsed("{threads: 1, cutting_force_factor: 0}", now), (LiveSettings{1e-4, 1, Vec3(1, 2, 3), 0}));
}

TEST(LiveSettings, AreRefusedAsInTheScene) {
  EXPECT_EQ(complaintOfChange("{tolerance: 0.5}"), "here: tolerance: '0.5' (allowed: 1e-12 to 0.1)");
  EXPECT_EQ(complaintOfChange("{threads: 0}"), "here: threads: '0' (allowed: a whole number, 1 to 64)");
  EXPECT_EQ(complaintOfChange("{gravity_y: .nan}"), "here: gravity_y: '.nan' (allowed: a finite number)");
  EXPECT_EQ(complaintOfChange("{cutting_force_factor: -1}"), "here: cutting_force_factor: '-1' (allowed: 0 or more)");
  EXPECT_NE(complaintOfChange("{time_step: 0.1}").find("time_step: unknown key"), std::string::npos);
  LiveSettings settings = liveSettingsOf(Scene());
  settings.threads = 65;
  EXPECT_NE(whyInvalid(settings), "");
}

}  // namespace
}  // namespace incision
