#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "support/blade.h"
#include "support/cuts.h"
#include "support/tool.h"

namespace incision {
namespace {

/// Farthest cut corner from where `distance` is zero [m].
template <typename Distance>
double farthest(const DeformableBody& body, const Distance& distance) {
  double most = 0;
  for (const Vec3& corner : cutCorners(body.mesh())) most = std::max(most, std::abs(distance(corner)));
  return most;
}

/// An oblique straight path from before the plate, past a node's neighbourhood, to behind it.
Pose oblique(double s) { return poseAt(-0.1 + 1.2 * s, 0.11 + 0.31 * s); }
double fromOblique(const Vec3& X) { return Vec3(-0.31, 1.2, 0).normalized().dot(X - oblique(0).position); }

/// An arc of radius 0.6 m round the origin.
Pose arc(double s) {
  const double angle = -0.1 + 1.1 * s;
  return poseAt(0.6 * std::cos(angle), 0.6 * std::sin(angle));
}
double fromArc(const Vec3& X) { return X.head<2>().norm() - 0.6; }

struct Rate {
  int moves;
  std::size_t a_step;
};
const std::vector<Rate> RATES = {{1, 1}, {9, 1}, {50, 1}, {400, 1}, {400, 40}, {400, 401}};

TEST(StrokePath, AStraightCutIsPlaneToRoundingAtEveryRateOfPoses) {
  for (const Rate& rate : RATES) {
    DeformableBody body(plateAndBlade(), loadMesh(plateAndBlade()));
    draw(&body, along(rate.moves, oblique), rate.a_step);
    // A node nearer than SNAP edges is taken to lie in the cut.
    EXPECT_LT(farthest(body, fromOblique), SNAP * cellOf(body.scene())) << rate.moves;
    EXPECT_EQ(body.counts().pieces, 2) << rate.moves;
    EXPECT_EQ(body.counts().cracks, 1) << rate.moves;
  }
}

TEST(StrokePath, ACurvedCutIsTheSameWithinAFractionOfAnElementAtEveryRateOfPoses) {
  for (const Rate& rate : RATES) {
    if (rate.moves < 20) continue;  // those are polygons
    DeformableBody body(plateAndBlade(), loadMesh(plateAndBlade()));
    draw(&body, along(rate.moves, arc), rate.a_step);
    EXPECT_EQ(body.counts().pieces, 2) << rate.moves << " " << rate.a_step;
    EXPECT_EQ(body.counts().cracks, 1) << rate.moves << " " << rate.a_step;
    // One plane in each element, along the way of the last half one: it strays by r (1 − cos(h/r)) ≈ 0.1 h.
    EXPECT_LT(farthest(body, fromArc), 0.3 * cellOf(body.scene())) << rate.moves << " " << rate.a_step;
  }
}

TEST(StrokePath, TheHandsTrembleLeavesTheCutWithinItsOwnSize) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> tremble(-1, 1);
  for (const int moves : {30, 300}) {
    DeformableBody body(plateAndBlade(), loadMesh(plateAndBlade()));
    const double amplitude = 0.01 * cellOf(body.scene());
    const Vec3 across = Vec3(-0.31, 1.2, 0).normalized();
    draw(&body, along(moves, [&](double s) {
      Pose pose = oblique(s);
      pose.position += amplitude * tremble(random) * across;
      return pose;
    }));
    EXPECT_LT(farthest(body, fromOblique), 5 * amplitude) << moves;
    EXPECT_EQ(body.counts().pieces, 2) << moves;
    EXPECT_EQ(body.counts().cracks, 1) << moves;
  }
}

TEST(StrokePath, SawingCutsAsPushingDoes) {
  for (const double swing : {0.03, 0.09}) {
    DeformableBody body(plateAndBlade(), loadMesh(plateAndBlade()));
    draw(&body, along(240, [&](double s) {
      Pose pose = oblique(s);
      pose.position.z() = swing * std::sin(200 * s);
      return pose;
    }));
    EXPECT_LT(farthest(body, fromOblique), SNAP * cellOf(body.scene()));
    EXPECT_EQ(body.counts().pieces, 2);
    EXPECT_EQ(body.counts().cracks, 1);
  }
}

TEST(StrokePath, ASlicingEdgeCutsThePlaneItLiesIn) {
  // Tilted by 30° in the plane of the cut, and drawn along itself four times as far as it advances.
  const Eigen::Quaterniond tilt(Eigen::AngleAxisd(M_PI / 6, Vec3::UnitY()));
  Scene scene = plateAndBlade();
  bladeOf(&scene.tools[0]).edge = Edge{Vec3(0, 0, -3), Vec3(0, 0, 3)};
  for (const int moves : {25, 250}) {
    DeformableBody body(scene, loadMesh(scene));
    const Vec3 edge = tilt * Vec3::UnitZ();
    draw(&body, along(moves, [&](double s) {
      Pose pose;
      pose.position = Vec3(-0.3 + 1.6 * s, 0.21, 0.1) + (1.5 - 3 * s) * edge;
      pose.orientation = tilt;
      return pose;
    }));
    EXPECT_LT(farthest(body, [](const Vec3& X) { return X.y() - 0.21; }), 1e-12) << moves;
    EXPECT_EQ(body.counts().pieces, 2) << moves;
    EXPECT_EQ(body.counts().cracks, 1) << moves;
  }
}

TEST(StrokePath, ABladePressedInFromAboveCutsToItsDepthAlongItsLength) {
  // Along x over a part of the plate, pressed down to half its thickness, in a mesh of 8 cells over that.
  Scene scene;
  scene.body.grid = GridSettings{{8, 4, 8}, Vec3(0.4, 0.2, 0.4), Vec3::Zero()};
  scene.gravity = Vec3::Zero();
  scene.solver.method = Method::DIRECT;
  scene.tools = {bladeTool(Edge{Vec3(0.1, 0.08, 0), Vec3(0.3, 0.08, 0)})};
  DeformableBody body(scene, loadMesh(scene));
  draw(&body, along(40, [](double s) { return poseAt(0, 0, 0.45 - 0.25 * s); }));
  EXPECT_EQ(body.counts().pieces, 1);
  const double cell = 0.05;
  for (const Vec3& X : cutCorners(body.mesh())) {
    EXPECT_NEAR(X.y(), 0.08, 1e-12);
    EXPECT_GT(X.x(), 0.1 - cell);
    EXPECT_LT(X.x(), 0.3 + cell);
    EXPECT_GT(X.z(), 0.2 - cell);
  }
  const StepResult still = body.step();
  // A point stands for a hundredth of an element's section, and elements begin to open at FIRST_SHARE of theirs.
  EXPECT_NEAR(still.tools[0].stroke_area, 0.2 * 0.2, 0.03 * 0.04);
  EXPECT_NEAR(still.tools[0].depth, 0.08, 0.03);  // the side at y = 0 is the nearest skin
}

// A body that is restored looks at the whole sweep again, another one only at what has changed since the last step. A
// plane cuts through the slit meanwhile.
TEST(StrokePath, CutsTheSameWhereItLooksAgainAtAllThatItHasSwept) {
  std::mt19937 random(3);
  std::normal_distribution<double> tremble(0, 0.01);
  const auto shaken = [&](double s) {
    Pose pose = arc(s);
    pose.position += Vec3(tremble(random), tremble(random), tremble(random));
    return pose;
  };
  for (const std::vector<Pose>& path : {along(60, oblique), along(60, arc), along(120, shaken)}) {
    DeformableBody once(plateAndBlade(), loadMesh(plateAndBlade())), again(plateAndBlade(), loadMesh(plateAndBlade()));
    for (std::size_t k = 0; k < path.size(); ++k) {
      std::ostringstream saved;
      again.save(saved);
      again.restore(saved.str());
      for (DeformableBody* body : {&once, &again}) {
        if (2 * k == path.size() - path.size() % 2) body->cut(plane(Vec3(0.31, 0.3, 0.1), Vec3(1, 0.3, 0.2)));
        body->guideTool({path[k]});
        body->step();
      }
    }
    EXPECT_GT(once.counts().crack_elements, 50);
    EXPECT_EQ(once.stateHash(), again.stateHash());
  }
}

TEST(StrokePath, AScrewedBladeCutsAHelicalSurface) {
  // It turns round its way by a quarter while it goes through.
  for (const int moves : {30, 300}) {
    Scene scene = plateAndBlade();
    bladeOf(&scene.tools[0]).edge = Edge{Vec3(0, 0, -1), Vec3(0, 0, 1)};
    DeformableBody body(scene, loadMesh(scene));
    const double turn = 0.8;
    draw(&body, along(moves, [&](double s) {
      Pose pose = poseAt(-0.1 + 1.2 * s, 0.26, 0.125);
      pose.orientation = Eigen::AngleAxisd(turn * s, Vec3::UnitX());
      return pose;
    }));
    EXPECT_EQ(body.counts().pieces, 2) << moves;
    EXPECT_EQ(body.counts().cracks, 1) << moves;
    const auto off = [&](const Vec3& X) {
      const double angle = turn * (X.x() + 0.1) / 1.2;
      return (X.y() - 0.26) * std::cos(angle) + (X.z() - 0.125) * std::sin(angle);
    };
    EXPECT_LT(farthest(body, off), 0.15 * cellOf(body.scene())) << moves;
  }
}

}  // namespace
}  // namespace incision
