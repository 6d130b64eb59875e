#include "incision/fem/patches.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "support/deformed_mesh.h"
#include "support/fan_mesh.h"
#include "support/rig.h"

namespace incision {
namespace {

const GridSettings BOX = {{3, 3, 3}, Vec3::Ones(), Vec3::Zero()};
const Material STIFF_IN_VOLUME = {1e5, 0.4999, 1000, 0, 0};

std::vector<int> sizesOf(const std::vector<int>& set_of) {
  std::map<int, int> count;
  for (int set : set_of) ++count[set];
  std::vector<int> sizes;
  for (const auto& [set, size] : count) sizes.push_back(size);
  return sizes;
}

// Expects equal sets, however they are numbered.
void expectSameSets(const Patches& a, const Patches& b, int parts) {
  std::map<int, int> match;
  std::set<int> taken;
  for (int p = 0; p < parts; ++p) {
    const auto [at, is_new] = match.try_emplace(a.of(p), b.of(p));
    EXPECT_EQ(at->second, b.of(p)) << "part " << p;
    if (is_new) {
      EXPECT_TRUE(taken.insert(b.of(p)).second) << "part " << p;
    }
  }
}

test::DeformedMesh cutBox(test::Random* random) {
  test::DeformedMesh cut(test::jitteredGrid(BOX, 0.2, random));
  for (int k = 0; k < 5; ++k) cut.cut(k % 2 ? random->rectangle(BOX, 0.3, 1) : random->plane(BOX));
  return cut;
}

TEST(EdgeClusters, OfAGridAreItsCells) {
  const TetMesh mesh = block({4, 3, 2}, Vec3(1, 1.3, 0.2));
  const std::vector<int> clusters = edgeClusters(mesh, buildTopology(mesh), Regions());
  for (std::size_t e = 0; e < clusters.size(); ++e) EXPECT_EQ(clusters[e], clusters[e - e % 6]);
  EXPECT_EQ(sizesOf(clusters), std::vector<int>(24, 6));
}

TEST(EdgeClusters, OfElementsInAnyOrderAreOfMiddlingSize) {
  test::Random random(91);
  const TetMesh mesh = test::jitteredGrid({{5, 5, 5}, Vec3::Ones(), Vec3::Zero()}, 0.3, &random);
  for (int size : sizesOf(edgeClusters(mesh, buildTopology(mesh), Regions()))) {
    EXPECT_GE(size, 3);
    EXPECT_LE(size, 12);
  }
}

TEST(EdgeClusters, AnEdgeWithTooManyElementsMakesNone) {
  constexpr int RIM = 1000;
  const TetMesh fan = fanMesh(RIM);
  EXPECT_EQ(sizesOf(edgeClusters(fan, buildTopology(fan), Regions())), std::vector<int>(RIM, 1));
}

TEST(Patches, EndAtCracks) {
  test::Random random(92);
  for (int run = 0; run < 10; ++run) {
    const test::DeformedMesh cut = cutBox(&random);
    Patches patches(cut.mesh, Regions());
    patches.topologyChanged({});
    int pieces = 0;
    const std::vector<int> piece = cut.mesh.copyPieces(&pieces);
    ASSERT_GT(pieces, 1);
    for (int a = 0; a < patches.count(); ++a) {
      ASSERT_GT(patches.parts()[a].size(), 0);
      for (int copy : patches.copies()[a]) EXPECT_EQ(piece[copy], piece[patches.copies()[a][0]]);
    }
  }
}

TEST(Patches, EndAtRegions) {
  test::Random random(97);
  const TetMesh mesh = test::jitteredGrid(BOX, 0.2, &random);
  RegionSettings core;
  core.place = {Vec3(0.3, 0.3, 0.3), Vec3(0.7, 0.7, 0.7)};
  const Regions regions(mesh, {core});
  const std::vector<int> clusters = edgeClusters(mesh, buildTopology(mesh), regions);
  std::map<int, int> region_of;  // of each cluster
  std::set<int> met;
  for (std::size_t e = 0; e < clusters.size(); ++e) {
    const int region = regions.of(static_cast<int>(e));
    met.insert(region);
    EXPECT_EQ(region_of.try_emplace(clusters[e], region).first->second, region);
  }
  EXPECT_EQ(met.size(), 2u);
}

TEST(Patches, EditedAfterCutsAreTheOnesMadeAnew) {
  test::Random random(93);
  for (int run = 0; run < 10; ++run) {
    test::DeformedMesh cut(test::jitteredGrid(BOX, 0.2, &random));
    Patches edited(cut.mesh, Regions());
    edited.topologyChanged({});
    for (int k = 0; k < 6; ++k) {
      edited.topologyChanged(cut.cut(k % 2 ? random.rectangle(BOX, 0.3, 1) : random.plane(BOX)).touched);
      Patches anew(cut.mesh, Regions());
      anew.topologyChanged({});
      expectSameSets(edited, anew, static_cast<int>(cut.mesh.parts().size()));
    }
  }
}

// f is affine in y while the rotations stay, and A is its slope.
TEST(AveragedPressure, TheMatrixIsTheSlopeOfTheForces) {
  test::Random random(94);
  test::DeformedMesh cut = cutBox(&random);
  const Materials materials(cut.mesh.mesh(), STIFF_IN_VOLUME);
  Assembly assembly(cut.mesh, materials, Mass::LUMPED, Pressure::AVERAGED, true, 2);
  assembly.topologyChanged(cut.x);
  cut.shake(0.1, &random);
  assembly.rotate(cut.x);
  const Eigen::SparseMatrix<double> K = systemMatrix(assembly, {0, 1}, allCopies(cut.mesh));
  std::vector<Vec3> ends = cut.x, from, to;
  Eigen::VectorXd u(K.rows());
  for (std::size_t c = 0; c < ends.size(); ++c) {
    u.segment<3>(3 * static_cast<int>(c)) = random.vector(0.1);
    ends[c] += u.segment<3>(3 * static_cast<int>(c));
  }
  assembly.elasticForces(cut.x, &from);
  assembly.elasticForces(ends, &to);
  const Eigen::VectorXd change = K * u;
  for (std::size_t c = 0; c < ends.size(); ++c)
    EXPECT_LT((to[c] - from[c] - change.segment<3>(3 * static_cast<int>(c))).norm(), 1e-11 * change.norm());
  EXPECT_LT((K - Eigen::SparseMatrix<double>(K.transpose())).norm(), 1e-14 * K.norm());
}

// Without warping the energy is quadratic, so its central difference is exact.
TEST(AveragedPressure, ForcesAreTheSlopeOfTheEnergy) {
  test::Random random(95);
  test::DeformedMesh cut = cutBox(&random);
  const Materials materials(cut.mesh.mesh(), STIFF_IN_VOLUME);
  Assembly assembly(cut.mesh, materials, Mass::LUMPED, Pressure::AVERAGED, false, 1);
  assembly.topologyChanged(cut.x);
  cut.shake(0.1, &random);
  std::vector<Vec3> ahead = cut.x, behind = cut.x, forces;
  assembly.elasticForces(cut.x, &forces);
  double work = 0, size = 0;
  for (std::size_t c = 0; c < cut.x.size(); ++c) {
    const Vec3 d = random.vector(0.05);
    ahead[c] += d;
    behind[c] -= d;
    work += 2 * forces[c].dot(d);
    size += 2 * forces[c].norm() * d.norm();
  }
  EXPECT_NEAR(assembly.elasticEnergy(ahead) - assembly.elasticEnergy(behind), work, 1e-12 * size);
}

TEST(AveragedPressure, StressesOfAllAreThoseOfEach) {
  test::Random random(96);
  test::DeformedMesh cut = cutBox(&random);
  const Materials materials(cut.mesh.mesh(), STIFF_IN_VOLUME);
  Assembly assembly(cut.mesh, materials, Mass::LUMPED, Pressure::AVERAGED, true, 2);
  assembly.topologyChanged(cut.x);
  cut.shake(0.05, &random);
  assembly.rotate(cut.x);
  std::vector<Mat3> all;
  assembly.stresses(cut.x, &all);
  for (std::size_t p = 0; p < all.size(); ++p)
    EXPECT_LT((all[p] - assembly.stress(static_cast<int>(p), cut.x)).norm(), 1e-11 * STIFF_IN_VOLUME.lambda());
}

// Four cells deep, whole and slit. Plain elements bend less than half as far as beam theory has it.
TEST(AveragedPressure, NearlyIncompressibleBarsBend) {
  constexpr double E = 1e5, L = 1, H = 0.25, TRACTION = 10;
  const double deflection = TRACTION * H * H * L * L * L / (3 * E * H * H * H * H / 12);
  for (const auto& [pressure, least, most] :
       {std::tuple{Pressure::ELEMENT, 0.0, 0.5}, std::tuple{Pressure::AVERAGED, 0.75, 1.02}})
    for (const std::vector<PlaneCut>& cuts :
         {std::vector<PlaneCut>{}, {rectangle(Vec3(0.5, 0.13, 0.13), Vec3(0, 1, 0.1), Vec3::UnitX(), 0.8, 0.4)}}) {
      RigSettings settings = statics(E, 0.4999);
      settings.pressure = pressure;
      settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
      settings.conditions.loads = {{slab(0, L), Vec3(0, 0, -TRACTION), 0}};
      Rig rig(block({16, 4, 4}, Vec3(L, H, H)), settings);
      for (const PlaneCut& cut : cuts) ASSERT_TRUE(rig.cut(cut).changed());
      ASSERT_TRUE(rig.advance());
      const double bent = largest(rig.displacements());
      EXPECT_GT(bent, least * deflection);
      EXPECT_LT(bent, most * deflection);
    }
}

}  // namespace
}  // namespace incision
