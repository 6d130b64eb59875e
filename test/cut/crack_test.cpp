#include "incision/cut/crack.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/cut_laws.h"
#include "support/deformed_mesh.h"
#include "support/scenes.h"

namespace incision {
namespace {

using test::DeformedMesh;
using test::plane;
using test::rectangle;

const GridSettings SMALL_CUBE = {{2, 2, 2}, Vec3::Ones(), Vec3::Zero()};
constexpr double EDGE = 0.5;  // shortest edge of SMALL_CUBE

TEST(PlaneCut, WithoutFiniteNumbersOrADirectionIsInvalid) {
  const double bad[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 1e200};
  EXPECT_EQ(whyInvalid(plane(Vec3::Zero(), Vec3(0, 0, 1e-200))), "");
  EXPECT_NE(whyInvalid(plane(Vec3::Zero(), Vec3::Zero())), "");
  for (double value : bad) {
    EXPECT_NE(whyInvalid(plane(Vec3(0, value, 0), Vec3::UnitX())), "");
    EXPECT_NE(whyInvalid(plane(Vec3::Zero(), Vec3(value, 0, 0))), "");
    EXPECT_NE(whyInvalid(rectangle(Vec3::Zero(), Vec3::UnitX(), Vec3(0, value, 0), 1, 1)), "");
    EXPECT_NE(whyInvalid(rectangle(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), value, 1)), "");
    EXPECT_NE(whyInvalid(rectangle(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), 1, value)), "");
  }
  EXPECT_NE(whyInvalid(rectangle(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), -1, 1)), "");
}

TEST(PlaneCut, NeedsATangentOnlyWhenBounded) {
  for (const Vec3& tangent : {Vec3(0, 0, 0), Vec3(2, 0, 0)}) {
    EXPECT_EQ(whyInvalid(rectangle(Vec3::Zero(), Vec3::UnitX(), tangent, 0, 0)), "");
    EXPECT_NE(whyInvalid(rectangle(Vec3::Zero(), Vec3::UnitX(), tangent, 1, 0)), "");
    EXPECT_NE(whyInvalid(rectangle(Vec3::Zero(), Vec3::UnitX(), tangent, 0, 1)), "");
  }
}

TEST(PlaneField, IsTheSignedDistanceOfTheCopiesCurrentPositions) {
  test::Random random(4);
  DeformedMesh body(gridMesh(SMALL_CUBE));
  body.shake(0.2, &random);
  const PlaneCut cut = plane(Vec3(0.1, 0.2, 0.3), Vec3(3, -4, 12));
  const CrackField field = planeField(cut, body.mesh, body.x);
  EXPECT_FALSE(field.contains);
  for (std::size_t c = 0; c < body.x.size(); ++c)
    EXPECT_NEAR(field.phi[c], (Vec3(3, -4, 12) / 13).dot(body.x[c] - cut.point), 1e-15);
}

TEST(PlaneField, LengthGoesAlongTheTangentAndWidthAcross) {
  DeformedMesh body(gridMesh(SMALL_CUBE));
  // What the tangent has along the normal does not count.
  const CrackField field =
      planeField(rectangle(Vec3::Constant(0.5), Vec3::UnitZ(), Vec3(1, 0, 5), 0.8, 0.2), body.mesh, body.x);
  const auto contains = [&](const Vec3& X) {
    for (int p = 0; p < static_cast<int>(body.mesh.parts().size()); ++p) {
      const auto& nodes = body.mesh.mesh().elements[p];
      Mat3 D;
      for (int I = 1; I < 4; ++I) D.col(I - 1) = body.mesh.mesh().nodes[nodes[I]] - body.mesh.mesh().nodes[nodes[0]];
      Barycentric b;
      b.tail<3>() = D.inverse() * (X - body.mesh.mesh().nodes[nodes[0]]);
      b[0] = 1 - b.tail<3>().sum();
      if (b.minCoeff() >= -1e-12) return field.contains(p, {b, b, b});
    }
    ADD_FAILURE() << "outside the body";
    return false;
  };
  EXPECT_TRUE(contains({0.11, 0.5, 0.5}));
  EXPECT_FALSE(contains({0.09, 0.5, 0.5}));
  EXPECT_TRUE(contains({0.5, 0.59, 0.5}));
  EXPECT_FALSE(contains({0.5, 0.61, 0.5}));
}

TEST(Snap, APlaneWithinSnapOfNodesGoesThroughThem) {
  for (double offset : {0.0, 0.9 * SNAP * EDGE, -0.9 * SNAP * EDGE}) {
    DeformedMesh body(gridMesh(SMALL_CUBE));
    const Insertion done = body.cut(plane(Vec3(0.5 + offset, 0, 0), Vec3::UnitX()));
    EXPECT_EQ(done.parts_split, 0);
    EXPECT_EQ(done.faces_severed, 8);
    EXPECT_EQ(done.copies_added, 9);
    EXPECT_EQ(body.pieces(), 2);
  }
  DeformedMesh body(gridMesh(SMALL_CUBE));
  EXPECT_GT(body.cut(plane(Vec3(0.5 + 1.1 * SNAP * EDGE, 0, 0), Vec3::UnitX())).parts_split, 0);
  EXPECT_EQ(body.pieces(), 2);
}

TEST(Snap, IsAtMostAThousandthOfTheEdge) { EXPECT_LE(SNAP, 1e-3); }

TEST(Sever, NeedsPartsOnOppositeSides) {
  TetMesh two;
  two.nodes = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)};
  two.elements = {{0, 1, 2, 3}, {0, 2, 1, 4}};
  DeformedMesh apart(two);
  EXPECT_EQ(apart.cut({0, 0, 0, 1, -1}).faces_severed, 1);
  EXPECT_EQ(apart.pieces(), 2);
  // Folded onto each other, both lie on one side.
  for (double side : {1.0, -1.0}) {
    DeformedMesh folded(two);
    EXPECT_FALSE(folded.cut({0, 0, 0, side, side}).changed());
    EXPECT_EQ(folded.pieces(), 1);
  }
  // All zero counts as positive.
  DeformedMesh flat(two);
  EXPECT_FALSE(flat.cut({0, 0, 0, 0, 1}).changed());
  EXPECT_EQ(flat.cut({0, 0, 0, 0, -1}).faces_severed, 1);
}

TEST(Sever, APlaneAlongTheSkinDoesNothing) {
  for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(-1, 0, 0)}) {
    DeformedMesh body(gridMesh(SMALL_CUBE));
    EXPECT_FALSE(body.cut(plane(Vec3::Zero(), normal)).changed());
    EXPECT_EQ(body.mesh.numCracks(), 0);
  }
}

// The side of a plane, told by rest positions, on which the parts of a node's own copy lie; 0 when on both.
int sideOfOwnCopy(const CutMesh& mesh, int node, const Vec3& point, const Vec3& normal) {
  int positive = 0, negative = 0;
  for (int p = 0; p < static_cast<int>(mesh.parts().size()); ++p)
    for (int I = 0; I < 4; ++I)
      if (mesh.parts()[p].copies[I] == mesh.ownCopy(node)) {
        Vec3 centre = Vec3::Zero();
        for (int J = 0; J < 4; ++J)
          centre += mesh.centroid(p)[J] * mesh.mesh().nodes[mesh.mesh().elements[mesh.parts()[p].element][J]];
        ++(normal.dot(centre - point) > 0 ? positive : negative);
      }
  return positive && negative ? 0 : positive ? 1 : -1;
}

constexpr int MIDDLE = (1 * 3 + 1) * 3 + 1;  // node (½, ½, ½) of SMALL_CUBE

TEST(OwnCopy, OfANodeOnACrackIsThePositiveOne) {
  for (const Vec3& normal : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, -1), Vec3(1, 2, -0.5), Vec3(-1, -2, 0.5)}) {
    DeformedMesh body(gridMesh(SMALL_CUBE));
    body.cut(plane(Vec3::Constant(0.5), normal));
    EXPECT_EQ(sideOfOwnCopy(body.mesh, MIDDLE, Vec3::Constant(0.5), normal), 1);
  }
}

TEST(OwnCopy, OfANodeOnSeveralCracksIsPositiveInTheirOrder) {
  const Vec3 first(1, 0.3, 0.2), second(-0.2, 1, 0.4), third(0.1, -0.3, 1);
  DeformedMesh body(gridMesh(SMALL_CUBE));
  for (const Vec3& normal : {first, second, third}) body.cut(plane(Vec3::Constant(0.5), normal));
  EXPECT_EQ(body.pieces(), 8);
  for (const Vec3& normal : {first, second, third})
    EXPECT_EQ(sideOfOwnCopy(body.mesh, MIDDLE, Vec3::Constant(0.5), normal), 1);
}

TEST(OwnCopy, PrefersTheEarlierCrackWhereBothCannotBePositive) {
  const int edge_node = (0 * 3 + 1) * 3 + 1;  // (0, ½, ½): beyond it there is no material with x < 0
  const Vec3 point(0, 0.5, 0.5), up(-1, 1, 0), down(-1, -1, 0);
  for (const auto& [first, second] : {std::pair(up, down), std::pair(down, up)}) {
    DeformedMesh body(gridMesh(SMALL_CUBE));
    body.cut(plane(point, first));
    body.cut(plane(point, second));
    EXPECT_EQ(body.pieces(), 3);
    EXPECT_EQ(sideOfOwnCopy(body.mesh, edge_node, point, first), 1);
    EXPECT_EQ(sideOfOwnCopy(body.mesh, edge_node, point, second), -1);
  }
}

TEST(OwnCopy, OfANodeOffTheCrackIsThatOfThePartsThatHoldIt) {
  test::Random random(5);
  for (int run = 0; run < 50; ++run) {
    DeformedMesh body(test::jitteredGrid(SMALL_CUBE, 0.2, &random));
    const PlaneCut cut = random.plane(SMALL_CUBE);
    const CrackField field = planeField(cut, body.mesh, body.x);
    body.cut(cut);
    for (int n = 0; n < 27; ++n)
      for (int p = 0; p < static_cast<int>(body.mesh.parts().size()); ++p)
        for (int I = 0; I < 4; ++I)
          if (body.mesh.mesh().elements[body.mesh.parts()[p].element][I] == n && body.mesh.holdsNode(p, I) &&
              field.phi[n] != 0) {
            EXPECT_EQ(body.mesh.parts()[p].copies[I], body.mesh.ownCopy(n));
          }
  }
}

}  // namespace
}  // namespace incision
