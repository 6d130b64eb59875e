#include <gtest/gtest.h>

#include "incision/cut/section.h"
#include "support/scenes.h"

namespace incision {
namespace {

double largestOfCopies(const DeformableBody& body) {
  double largest = 0;
  for (int c = 0; c < body.mesh().numCopies(); ++c)
    largest = std::max(largest, (body.positions()[c] - body.mesh().mesh().nodes[body.mesh().copyNode(c)]).norm());
  return largest;
}

/// A bar held at its right end, with its left edge at the ground a hinge. It is pulled to the left.
Scene hingedBar() {
  Scene scene = test::softBar();
  scene.gravity = Vec3(-1, 0, 0);
  scene.boundary = {{{Vec3(1 - 1e-6, -1, -1), Vec3(2, 1, 1)}, Vec3::Zero()},
                    {{Vec3(-1, -1, -1), Vec3(1e-6, 1, 1e-6)}, Vec3::Zero()}};
  return scene;
}

TEST(MaxDisplacement, OfAnUncutBodyIsThatOfItsNodes) {
  DeformableBody body(hingedBar(), loadMesh(hingedBar()));
  test::run(&body, 30);
  EXPECT_GT(body.motion().max_displacement, 1e-3);
  EXPECT_NEAR(body.motion().max_displacement, largestOfCopies(body), 1e-15);
}

// The cut leaves a thin slab, which falls over about the hinge. Its copies on the far side of the cut turn with it, an
// element's length away from its material.
TEST(MaxDisplacement, IsThatOfTheMaterialNotOfCopiesOutsideTheirPart) {
  const double thickness = 0.01;
  DeformableBody body(hingedBar(), loadMesh(hingedBar()));
  ASSERT_EQ(body.cut(test::plane(Vec3(thickness, 0, 0), Vec3::UnitX())).pieces, 2);
  test::run(&body, 30);

  double largest = 0, farthest_x = 1;
  for (std::size_t p = 0; p < body.mesh().parts().size(); ++p) {
    const Part& part = body.mesh().parts()[p];
    for (const Barycentric& corner : body.mesh().polytope(static_cast<int>(p)).corners) {
      const Vec3 X = atRest(body.mesh(), part.element, corner);
      const double moved = (at(part, corner, body.positions()) - X).norm();
      if (moved > largest) farthest_x = X.x();
      largest = std::max(largest, moved);
    }
  }
  EXPECT_LE(farthest_x, thickness + 1e-12);  // the slab has moved farthest
  EXPECT_NEAR(body.motion().max_displacement, largest, 1e-12);
  EXPECT_GT(largestOfCopies(body), 1.02 * largest);
}

}  // namespace
}  // namespace incision
