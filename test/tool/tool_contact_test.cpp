#include <gtest/gtest.h>

#include "incision/base/input_error.h"
#include "support/sanitized.h"
#include "support/tool_rig.h"

namespace incision {
namespace {

constexpr double E = 1e5, SIDE = 0.2, ELEMENT = 0.05;  // of the block [Pa, m]
const std::array<int, 3> CELLS = {4, 4, 4};

TetMesh cube() { return block(CELLS, Vec3::Constant(SIDE)); }

ContactSettings touchingNothing() {
  ContactSettings settings;
  settings.self = false;
  return settings;
}

/// A block of 8 kg, damped.
RigSettings damped() {
  RigSettings settings;
  settings.material = {E, 0.3, 1000, 0, 2e-3};
  settings.solver = {0.005, Method::DIRECT, 1e-8, 1};
  settings.conditions.clamps = {{slab(2, 0), Vec3::Zero()}};
  return settings;
}

/// A block held below in static equilibrium, without lateral strain, and a plate whose underside is 0.05 m below the
/// tool's origin.
struct PressedBlock : ToolRig {
  PressedBlock(double friction, const Vec3& offset = Vec3::Zero())
      : ToolRig(cube(), held(), touchingNothing(), toolUrdf("<box size='1 1 0.1'/>", textOf(offset)), friction) {
    place(above(0));
  }
  static RigSettings held() {
    RigSettings settings = statics(E, 0);
    settings.conditions.clamps = {{slab(2, 0), Vec3::Zero()}};
    return settings;
  }
  static std::string textOf(const Vec3& v) {
    return std::to_string(v.x()) + ' ' + std::to_string(v.y()) + ' ' + std::to_string(v.z());
  }
  static Pose above(double depth, double x = 0) { return at(Vec3(x, 0, SIDE + 0.05 - depth)); }
};

// F = E A δ / L, but the contact gives way by p h / (200 E) at most: on the rim it is stiffer.
TEST(ToolContacts, PressesABlockAsHookeSays) {
  for (const double depth : {1e-4, 2e-3}) {
    PressedBlock rig(0);
    rig.moveTo(rig.above(depth));
    const double most = E * SIDE * SIDE * depth / SIDE, least = most * SIDE / (SIDE + ELEMENT / OBSTACLE_STIFFNESS);
    EXPECT_LT(rig.onTool().force.z(), most);
    EXPECT_GT(rig.onTool().force.z(), least);
    EXPECT_LT(rig.onTool().force.head<2>().norm(), 1e-12 * most);
    rig.moveTo(rig.above(-depth));
    EXPECT_EQ(rig.onTool().force, Vec3::Zero());
  }
}

// The pressure on the top is even, but for what the contact gives way.
TEST(ToolContacts, TurnsTheToolByTheLever) {
  PressedBlock rig(0, Vec3(0.1, 0.03, 0));
  rig.moveTo(rig.above(1e-3));
  const Vec3 F = rig.onTool().force, middle(SIDE / 2, SIDE / 2, SIDE);
  const Pose pose{Vec3(0.5, 0.3, 0.1), Eigen::Quaterniond(0.8, 0, 0.6, 0)};
  const Wrench seen = seenFrom(pose, rig.onTool());
  EXPECT_LT((pose.orientation * seen.force - F).norm(), 1e-12 * F.norm());
  EXPECT_LT((pose.orientation * seen.torque - (middle - pose.position).cross(F)).norm(),
            ELEMENT / OBSTACLE_STIFFNESS * F.norm());
}

TEST(ToolContacts, IsNotThereWithoutAPose) {
  PressedBlock rig(0);
  rig.tool.in_place = false;
  EXPECT_EQ(rig.moveTo(rig.above(0.01)).count, 0);
  EXPECT_EQ(rig.onTool().force, Vec3::Zero());
}

// A block on the ground, dragged by the tool on it: in the end it slides where there is less friction.
TEST(ToolContacts, HasFrictionOfItsOwn) {
  for (const double friction : test::SANITIZED ? std::vector<double>{0.1} : std::vector<double>{0.1, 0.5}) {
    RigSettings settings = damped();
    settings.conditions.clamps.clear();
    ContactSettings touching = touchingNothing();
    touching.ground = 0;
    touching.friction = 0.3;
    ToolRig rig(cube(), settings, touching, toolUrdf("<box size='2 2 0.1'/>"), friction);
    rig.place(PressedBlock::above(0));
    const auto drag = [&](int first, int last) {
      Vec3 sum = Vec3::Zero();
      for (int k = first; k < last; ++k) {
        rig.moveTo(PressedBlock::above(2e-3, 5e-4 * k));
        sum += rig.onTool().force;
      }
      return sum;
    };
    drag(0, 300);
    const Vec3 F = drag(300, 500);
    // A step is content when 2 % of all friction there may be, above and below, is off its bound.
    EXPECT_NEAR(-F.x() / F.z(), std::min(friction, 0.3), 0.025 * (friction + 0.3));
  }
}

// A thin plate comes down on the block on its lower edge, which is the cutting one.
TEST(ToolContacts, GivesWayAtItsEdgeWhileThatCuts) {
  for (const bool cuts : {true, false}) {
    const Edge edge = {Vec3(-0.2, -0.002, -0.05), Vec3(0.2, -0.002, -0.05)};
    ToolRig rig(cube(), PressedBlock::held(), touchingNothing(), toolUrdf("<box size='0.4 0.004 0.1'/>"), 0, edge);
    rig.place(at(Vec3(0.1, 0.101, SIDE + 0.05)));
    rig.tool.active = cuts;
    const ContactReport touched = rig.moveTo(at(Vec3(0.1, 0.101, SIDE + 0.045)));
    EXPECT_EQ(touched.count, cuts ? 0 : CELLS[0] + 1);
    if (cuts)
      EXPECT_EQ(rig.onTool().force, Vec3::Zero());
    else
      EXPECT_GT(rig.onTool().force.z(), 0);
  }
}

// A free block hit by a ball that turns.
TEST(ToolContacts, TakesTheMomentumThatTheBodyGains) {
  RigSettings settings = damped();
  settings.conditions.clamps.clear();
  ToolRig rig(cube(), settings, touchingNothing(), toolUrdf("<sphere radius='0.08'/>"), 0.5);
  const auto pose = [](int k) {
    return Pose{Vec3(0.11 + 2e-3 * k, 0.08, SIDE + 0.08 - 3e-3 * k),
                Eigen::Quaterniond(Eigen::AngleAxisd(0.05 * k, Vec3::UnitY()))};
  };
  rig.place(pose(0));
  Vec3 given = Vec3::Zero();
  for (int k = 1; k <= 40; ++k) {
    rig.moveTo(pose(k));
    given -= rig.time_step * rig.onTool().force;
    ASSERT_LT((rig.momentum() - given).norm(), 1e-10 * given.norm() + 1e-20) << k;
  }
  EXPECT_LT(given.z(), -0.1);  // of 8 kg
}

/// A slit down to the middle of a block held below, and a thin box that is put into it without opening it, by its own
/// edge. `offset` is from the slit's plane to the middle of the box.
struct BladeInSlit : ToolRig {
  static constexpr double THICKNESS = 0.002, DEPTH = 0.05, PLANE = 0.11;

  explicit BladeInSlit(double offset)
      : ToolRig(cube(), damped(), touchingNothing(), toolUrdf("<box size='0.4 0.002 0.1'/>"), 0.3,
                {Vec3(-0.2, -THICKNESS / 2, -DEPTH), Vec3(0.2, -THICKNESS / 2, -DEPTH)}),
        middle(PLANE + offset) {
    EXPECT_TRUE(cut(rectangle(Vec3(0.1, PLANE, SIDE), Vec3::UnitY(), Vec3::UnitX(), 0, SIDE)).changed());
    EXPECT_EQ(pieces(), 1);
    surfaceChanged();
    place(at(Vec3(0.1, middle, SIDE)));
  }

  /// How far vertices of the slit are from the middle of the blade, towards their own material [m]; of those beside the
  /// blade where it does not give way.
  std::vector<double> openings() const {
    const std::vector<Vec3> x = surfacePositions(surface.get(), motion.x),
                            X = surfacePositions(surface.get(), restPositions(mesh));
    std::vector<double> openings;
    for (std::size_t t = 0; t < surface.get().triangles.size(); ++t) {
      if (!surface.get().cut_face[t]) continue;
      const auto& [a, b, c] = surface.get().triangles[t];
      const double out = (X[b] - X[a]).cross(X[c] - X[a]).y();
      for (const int v : surface.get().triangles[t])
        if (X[v].z() > SIDE - DEPTH + 2 * THICKNESS)
          openings.push_back(out > 0 ? middle - x[v].y() : x[v].y() - middle);
    }
    return openings;
  }

  double middle;
};

// Also where the slit runs in the plane of one of the blade's sides, as it does that an edge of the box has cut, or
// beside the blade by a hundredth of an element.
TEST(ToolContacts, OpensASlitToItsThicknessEachFaceToItsOwnSide) {
  constexpr double HALF = BladeInSlit::THICKNESS / 2;
  for (const double offset : {0.0, HALF, -HALF, HALF + 0.01 * ELEMENT}) {
    BladeInSlit rig(offset);
    ASSERT_GT(rig.openings().size(), 20u);
    double fastest = 0;
    for (int k = 0; k < 200; ++k) {
      rig.moveTo(rig.tool.groups[0].to);
      fastest = std::max(fastest, largest(rig.motion.v));
    }
    EXPECT_LT(fastest, 2 * RECOVERY * ELEMENT);
    // Pushed aside by at most 2.5 mm, 0.1 m from what holds it, it is pressed by less than E/20 and gives way by less
    // than h / (20 · 200).
    for (const double opening : rig.openings()) {
      EXPECT_GT(opening, HALF - ELEMENT / (20 * OBSTACLE_STIFFNESS)) << offset;
      EXPECT_LT(opening, 2 * HALF) << offset;
    }
    EXPECT_LT(largest(rig.motion.v), 1e-4);
  }
}

// A blade through the skin of a block that has not been cut there; a row of nodes lies in it.
TEST(ToolContacts, PushesSkinThatItPassesAsideAndNotAheadOfIt) {
  constexpr double HALF = BladeInSlit::THICKNESS / 2;
  ToolRig rig(cube(), damped(), touchingNothing(), toolUrdf("<box size='0.4 0.002 0.1'/>"), 0);
  rig.place(at(Vec3(0.1, 0.1 + 0.3 * HALF, SIDE + 0.01)));
  int count = 0;
  for (int k = 0; k < 200; ++k) count = rig.moveTo(rig.tool.groups[0].to).count;
  EXPECT_EQ(count, CELLS[0] + 1);
  EXPECT_LT(largest(rig.displacements()), 2 * HALF);
}

// Then only the end of the slit is left free.
TEST(ToolContacts, LeavesNothingBehindInASlit) {
  BladeInSlit rig(0);
  for (int k = 0; k < 200; ++k) rig.moveTo(rig.tool.groups[0].to);
  for (int k = 0; k < 400; ++k) rig.moveTo(at(Vec3(0.1, BladeInSlit::PLANE, SIDE + std::min(0.2, 2e-3 * k))));
  EXPECT_EQ(rig.onTool().force, Vec3::Zero());
  EXPECT_LT(largest(rig.displacements()), 1e-4);
}

std::string refusal(const std::string& urdf) {
  try {
    shapesOf(urdf);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(ToolContacts, IsRefusedWhereItIsNoneOfTheShapes) {
  EXPECT_EQ(refusal(toolUrdf("<mesh filename='a.stl'/>")),
            "tool.urdf: link 'blade': mesh 'a.stl' is relative, and the description comes from no file (allowed: "
            "package://NAME/FILE or an absolute path)");
  EXPECT_EQ(refusal(toolUrdf("<box size='0.1 0 0.1'/>")),
            "tool.urdf: link 'blade': the box's size 0 (allowed: 1e-06 to 1e+06 m)");
  EXPECT_EQ(refusal("<robot name='tool'><link name='handle'/></robot>"),
            "tool.urdf: link 'blade' does not exist (allowed: handle)");
  EXPECT_EQ(refusal("no xml").find("tool.urdf: not a robot description"), 0u);
  EXPECT_EQ(refusal(toolUrdf("<sphere radius='0.01'/>")), "");
}

}  // namespace
}  // namespace incision
