#include "incision/fem/boundary.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/loads.h"
#include "support/rig.h"

namespace incision {
namespace {

const RestBox EVERYWHERE = {Vec3::Constant(-10), Vec3::Constant(10)};

Insertion cut(CutMesh* mesh, const PlaneCut& plane) {
  return mesh->insert(planeField(plane, *mesh, restPositions(*mesh)));
}

CutMesh cutBlock(const std::vector<PlaneCut>& cuts) {
  CutMesh mesh(block({3, 2, 2}, Vec3(0.9, 0.6, 0.4)));
  for (const PlaneCut& plane : cuts) EXPECT_TRUE(cut(&mesh, plane).changed());
  return mesh;
}

const PlaneCut OBLIQUE = plane(Vec3(0.45, 0.3, 0.2), Vec3(0.5, 1, 0.7));

const std::vector<std::vector<PlaneCut>> DISSECTIONS = {
    {},
    {OBLIQUE},
    {OBLIQUE, plane(Vec3(0.45, 0.3, 0.2), Vec3(1, -0.5, 0.2))},
    {plane(Vec3(0.88, 0.6, 0.4), Vec3::Ones())},                                // a corner
    {plane(Vec3(0.45, 0.3, 0.2), Vec3::UnitY())},                               // along faces
    {rectangle(Vec3(0.9, 0.28, 0.2), Vec3(0, 1, 0.1), Vec3::UnitX(), 0.9, 0)},  // a slit
};

TEST(Tractions, SumToAreaTimesTractionHoweverCut) {
  const Vec3 t(3, -5, 7);
  for (const auto& cuts : DISSECTIONS) {
    const CutMesh mesh = cutBlock(cuts);
    const std::vector<Vec3> end = loadForces(mesh, {slab(0, 0.9), t, 0});
    const std::vector<Vec3> all = loadForces(mesh, {EVERYWHERE, t, 0});
    const std::vector<Vec3> X = restPositions(mesh);
    Vec3 end_force = Vec3::Zero(), end_moment = Vec3::Zero(), all_force = Vec3::Zero();
    for (int c = 0; c < mesh.numCopies(); ++c) {
      end_force += end[c];
      end_moment += X[c].cross(end[c]);
      all_force += all[c];
    }
    EXPECT_LT((end_force - 0.24 * t).norm(), 1e-12 * t.norm());
    EXPECT_LT((end_moment - Vec3(0.9, 0.3, 0.2).cross(0.24 * t)).norm(), 1e-12 * t.norm());
    // Cut faces are no boundary of the mesh: nothing pulls there.
    EXPECT_LT((all_force - 2 * (0.24 + 0.36 + 0.54) * t).norm(), 1e-12 * t.norm());
  }
}

TEST(Tractions, ActOnEachPieceByTheAreaItOwns) {
  const CutMesh mesh = cutBlock({plane(Vec3(0, 0.25, 0), Vec3::UnitY())});
  int pieces = 0;
  const std::vector<int> piece = mesh.copyPieces(&pieces);
  ASSERT_EQ(pieces, 2);
  const std::vector<Vec3> forces = loadForces(mesh, {slab(0, 0.9), Vec3::UnitX(), 0});
  std::vector<double> force(2, 0), height(2, 0);
  const std::vector<Vec3> X = restPositions(mesh);
  for (int c = 0; c < mesh.numCopies(); ++c) {
    force[piece[c]] += forces[c].x();
    height[piece[c]] += forces[c].x() * X[c].y();
  }
  const int lower = height[0] / force[0] < height[1] / force[1] ? 0 : 1;
  EXPECT_NEAR(force[lower], 0.25 * 0.4, 1e-12);
  EXPECT_NEAR(force[1 - lower], 0.35 * 0.4, 1e-12);
  // They act at the middle of each piece's area.
  EXPECT_NEAR(height[lower] / force[lower], 0.125, 1e-12);
  EXPECT_NEAR(height[1 - lower] / force[1 - lower], 0.425, 1e-12);
}

TEST(Tractions, NeedAllNodesOfAFaceInTheBox) {
  const CutMesh mesh = cutBlock({});
  RestBox half = slab(0, 0.9);
  half.max.y() = 0.3 + 1e-9;
  Vec3 sum = Vec3::Zero();
  for (const Vec3& f : loadForces(mesh, {half, Vec3::UnitX(), 0})) sum += f;
  EXPECT_NEAR(sum.x(), 0.12, 1e-12);
  half.max.y() = 0.29;
  for (const Vec3& f : loadForces(mesh, {half, Vec3::UnitX(), 0})) EXPECT_EQ(f, Vec3::Zero());
}

// How many copies of each piece are held at x = 0.
std::vector<int> heldOfPieces(const CutMesh& mesh, const std::vector<Clamp>& clamps) {
  int pieces = 0;
  const std::vector<int> piece = mesh.copyPieces(&pieces);
  const std::vector<int> held = heldCopies(mesh, clamps, heldNodes(mesh.mesh(), clamps));
  std::vector<int> count(pieces, 0);
  for (int c = 0; c < mesh.numCopies(); ++c) count[piece[c]] += held[c] >= 0;
  return count;
}

const std::vector<Clamp> CLAMP = {{slab(0, 0), Vec3::Zero()}};

TEST(HeldCopies, AreTheOwnOnesWhereNothingIsCut) {
  const CutMesh mesh = cutBlock({});
  EXPECT_EQ(heldOfPieces(mesh, CLAMP), std::vector<int>{9});
}

TEST(HeldCopies, DoNotHoldALoosePieceBesideTheClamp) {
  // Through the first cells, whose elements have nodes at x = 0.
  const CutMesh mesh = cutBlock({plane(Vec3(0.1, 0, 0), Vec3::UnitX())});
  ASSERT_GT(mesh.numCopies(), 36);
  std::vector<int> held = heldOfPieces(mesh, CLAMP);
  std::sort(held.begin(), held.end());
  EXPECT_EQ(held, (std::vector<int>{0, 9}));
}

TEST(HeldCopies, HoldBothPiecesOfACutAcrossTheClamp) {
  const CutMesh mesh = cutBlock({plane(Vec3(0, 0.25, 0), Vec3(0, 1, 0.1))});
  const std::vector<int> held = heldOfPieces(mesh, CLAMP);
  ASSERT_EQ(held.size(), 2u);
  // Each has all nodes of the clamped faces it owns a share of: two or three rows of three.
  for (int count : held) EXPECT_GE(count, 6);
}

TEST(HeldCopies, HoldAFragmentWithAShareOfAHeldElement) {
  const std::vector<Clamp> clamp = {{{Vec3(-1, -1, -1), Vec3(0.3 + 1e-9, 1, 1)}, Vec3::Zero()}};
  const CutMesh mesh = cutBlock({plane(Vec3(0.15, 0.1, 0.1), Vec3(1, 0.2, 0.1))});
  for (int count : heldOfPieces(mesh, clamp)) EXPECT_GE(count, 4);
}

TEST(HeldNodes, BelongToTheFirstHoldWhoseBoxHasThem) {
  const TetMesh mesh = block({1, 1, 1}, Vec3::Ones());
  const std::vector<int> held = heldNodes(mesh, {{slab(0, 0), Vec3::Zero()}, {slab(1, 0), Vec3::UnitX()}});
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    EXPECT_EQ(held[n], mesh.nodes[n].x() == 0 ? 0 : mesh.nodes[n].y() == 0 ? 1 : -1);
}

}  // namespace
}  // namespace incision
