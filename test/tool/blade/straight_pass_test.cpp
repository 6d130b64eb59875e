#include "support/straight_pass.h"

#include <gtest/gtest.h>

#include "support/sanitized.h"

namespace incision {
namespace {

/// The blade parts the body in one crack, whose faces were made within the blade's thickness and 5 % of an element of
/// the plane in which its edge moves. Where the body is held on both sides of that, so that it cannot bend, they lie
/// there at rest too.
void expectTwoPieces(unsigned first, unsigned last) {
  for (unsigned seed = first; seed < last; ++seed) {
    const test::StraightPass drawn = test::StraightPass::draw(seed);
    SCOPED_TRACE(::testing::Message() << drawn);
    test::PassUnderWay pass(drawn);
    pass.run();
    const double near = pass.thickness() + 0.05 * pass.size();
    EXPECT_EQ(pass.body().counts().pieces, 2);
    EXPECT_EQ(pass.body().counts().cracks, 1);
    EXPECT_LE(pass.farthest(), near);
    if (drawn.held == test::StraightPass::Held::BOTH_SIDES) {
      EXPECT_LE(pass.farthestAtRest(), near);
    }
  }
}

TEST(StraightPass, PartsABodyInOneCrackAlongItsPlane) { expectTwoPieces(0, test::SANITIZED ? 2 : 8); }

// Over all meshes, time steps, stiffnesses, thicknesses and frictions.
TEST(FullStraightPass, PartsABodyInOneCrackAlongItsPlane) { expectTwoPieces(8, test::SANITIZED ? 10 : 200); }

}  // namespace
}  // namespace incision
