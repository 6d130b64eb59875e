// A round crack in a block under tension, against the answer of linear elasticity.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/penny_crack.h"

namespace incision::test {
namespace {

constexpr double RADIUS = 1, TENSION = 1e3, YOUNG = 1e6, POISSON = 0.3;  // [m], [Pa]

/// Volume [m³] between the faces of the disc.
double openedVolume(const Rig& rig, const Insertion& done) {
  const std::vector<Vec3> u = rig.displacements();
  double volume = 0;
  for (int p : done.parts) {
    const Part &above = rig.mesh.parts()[p], &below = rig.mesh.parts()[above.next];
    for (const Facet& facet : rig.mesh.polytope(p).facets) {
      if (facet.crack < 0) continue;
      std::vector<Barycentric> corners;
      for (int c : facet.corners) corners.push_back(rig.mesh.polytope(p).corners[c]);
      const auto place = [&](const Barycentric& b) {
        Vec3 X = Vec3::Zero();
        for (int I = 0; I < 4; ++I) X += b[I] * rig.mesh.mesh().nodes[rig.mesh.mesh().elements[above.element][I]];
        return X;
      };
      for (std::size_t i = 2; i < corners.size(); ++i) {
        const Barycentric middle = (corners[0] + corners[i - 1] + corners[i]) / 3;
        const Vec3 a = place(corners[0]);
        const double area = (place(corners[i - 1]) - a).cross(place(corners[i]) - a).norm() / 2;
        for (int I = 0; I < 4; ++I) volume += area * middle[I] * (u[above.copies[I]] - u[below.copies[I]])[2];
      }
    }
  }
  return volume;
}

/// Share of the exact opened volume.
double openedShare(int cells) {
  const double exact = 16 * (1 - POISSON * POISSON) * TENSION * std::pow(RADIUS, 3) / (3 * YOUNG);
  RigSettings settings = statics(YOUNG, POISSON);
  // Holds the block, which nothing else does. With a tenth of it the iterative solver finds the block too loose.
  settings.material.density = 10;
  settings.solver = {1, Method::ITERATIVE, 1e-9, 2};
  settings.conditions.loads = {{slab(2, BLOCK_HALF), Vec3(0, 0, TENSION), 0},
                               {slab(2, -BLOCK_HALF), Vec3(0, 0, -TENSION), 0}};
  Rig rig(gradedBlock(cells), settings);
  const Insertion done = rig.cut(disc(RADIUS, rig.mesh, rig.motion.x));
  EXPECT_TRUE(rig.advance());
  return openedVolume(rig, done) / exact;
}

// A crack ends on faces of elements, whose copies hold together: it opens like one with a radius that is smaller by
// most of an element, and the volume goes with the third power of it. So the radius converges at first order.
TEST(PennyCrack, ItsOpenedVolumeConvergesAtFirstOrder) {
  const std::vector<int> cells = {15, 27, 39};  // odd: the crack passes no nodes
  std::vector<double> missing;                  // of the radius that has the volume
  for (const int n : cells) {
    const double share = openedShare(n);
    missing.push_back(1 - std::cbrt(share));
    std::printf("%d cells: %.3f of the exact volume, that of a radius of %.3f\n", n, share, std::cbrt(share));
  }
  const double refinement = static_cast<double>(cells[2]) / cells[0];
  const double order = std::log(missing[0] / missing[2]) / std::log(refinement);
  const double limit = 1 - (refinement * missing[2] - missing[0]) / (refinement - 1);
  std::printf("order %.2f, extrapolated volume %.3f\n", order, std::pow(limit, 3));
  EXPECT_LT(missing[1], missing[0]);
  EXPECT_GT(order, 0.85);
  EXPECT_NEAR(std::pow(limit, 3), 1, 0.05);  // the block ends at four radii
}

}  // namespace
}  // namespace incision::test
