#include <gtest/gtest.h>

#include <map>

#include "incision/fem/assembly.h"
#include "support/closed_surface.h"
#include "support/cut_laws.h"
#include "support/deformed_mesh.h"
#include "support/loads.h"
#include "support/scenes.h"

namespace incision {
namespace {

using test::clampLeftEnd;
using test::makeBody;
using test::plane;
using test::rectangle;
using test::softBar;

const Material TISSUE = {1e5, 0.3, 1000, 0, 0};
const GridSettings BAR = *softBar().body.grid;

// A body held at its left, falling and cut.
Scene cutInMotion(Method method, int threads) {
  Scene scene = softBar();
  scene.gravity = Vec3(0, 1, -9.81);
  scene.boundary = {clampLeftEnd()};
  scene.body.material.stiffness_damping = 1e-3;
  scene.solver.method = method;
  scene.solver.threads = threads;
  scene.cuts = test::crossingCuts(0);
  return scene;
}

TEST(InsertingACut, ChangesNeitherMassMomentumEnergyNorPositions) {
  for (Mass mass : {Mass::LUMPED, Mass::CONSISTENT}) {
    Scene scene = cutInMotion(Method::DIRECT, 1);
    scene.body.mass = mass;
    DeformableBody body = makeBody(scene);
    test::Random random(60);
    for (int k = 0; k < 8; ++k) {
      test::run(&body, 3);
      const BodyMotion before = body.motion();
      const std::vector<Vec3> nodes = body.nodePositions(), x = body.positions(), v = body.velocities();
      PlaneCut cut = k % 2 ? random.rectangle(BAR, 0.4, 0.8) : random.plane(BAR);
      cut.point = nodes[random.index(static_cast<int>(nodes.size()))] + random.vector(0.02);
      const CutResult result = body.cut(cut);
      ASSERT_EQ(result.status, CutStatus::APPLIED) << k << ": " << result.reason;

      const BodyMotion after = body.motion();
      EXPECT_NEAR(after.mass, before.mass, 1e-12 * before.mass);
      EXPECT_NEAR(after.mass, 62.5, 1e-12 * 62.5);
      EXPECT_LT((after.momentum - before.momentum).norm(), 1e-12 * before.momentum.norm());
      EXPECT_NEAR(after.kinetic_energy, before.kinetic_energy, 1e-12 * before.kinetic_energy);
      EXPECT_NEAR(after.elastic_energy, before.elastic_energy, 1e-10 * before.elastic_energy);
      EXPECT_EQ(test::largestDifference(body.nodePositions(), nodes), 0);
      for (std::size_t c = 0; c < body.positions().size(); ++c) {
        const std::size_t parent = c < x.size() ? c : body.mesh().copyParent(static_cast<int>(c));
        EXPECT_EQ(body.positions()[c], x[parent]);
        EXPECT_EQ(body.velocities()[c], v[parent]);
      }
    }
  }
}

TEST(CutBody, MassesAndVolumesAddUp) {
  test::Random random(61);
  const GridSettings box = {{3, 3, 3}, Vec3::Ones(), Vec3::Zero()};
  for (int run = 0; run < 10; ++run) {
    test::DeformedMesh cut(test::jitteredGrid(box, 0.2, &random));
    for (int k = 0; k < 6; ++k) cut.cut(k % 2 ? random.rectangle(box, 0.3, 1) : random.plane(box));
    const Materials materials(cut.mesh.mesh(), TISSUE);
    Assembly assembly(cut.mesh, materials, Mass::LUMPED, Pressure::ELEMENT, true, 1);
    assembly.topologyChanged(cut.x);
    double mass = 0;
    for (double m : assembly.masses()) {
      EXPECT_GT(m, 0);
      mass += m;
    }
    EXPECT_NEAR(mass, TISSUE.density, 1e-12 * TISSUE.density);
  }
}

TEST(RigidMotion, OfEachPieceByItselfGivesNoForce) {
  test::Random random(62);
  const GridSettings box = {{3, 3, 3}, Vec3::Ones(), Vec3::Zero()};
  for (int run = 0; run < 10; ++run) {
    test::DeformedMesh cut(test::jitteredGrid(box, 0.2, &random));
    for (int k = 0; k < 5; ++k) cut.cut(k % 2 ? random.rectangle(box, 0.3, 1) : random.plane(box));
    const Pressure pressure = run % 2 ? Pressure::AVERAGED : Pressure::ELEMENT;
    const Materials materials(cut.mesh.mesh(), TISSUE);
    Assembly assembly(cut.mesh, materials, Mass::LUMPED, pressure, true, 1);
    assembly.topologyChanged(cut.x);
    cut.scatter(1, &random);
    assembly.rotate(cut.x);
    std::vector<Vec3> forces;
    assembly.elasticForces(cut.x, &forces);
    // Rounding of positions near 1 m times the stiffness E × 1 m; the elements are smaller and their gradients larger.
    for (const Vec3& f : forces) EXPECT_LT(f.norm(), 1e-13 * TISSUE.young_modulus);
    EXPECT_LT(assembly.elasticEnergy(cut.x), 1e-20 * TISSUE.young_modulus);
  }
}

// Pull along x, with the side contraction that leaves the sides free of stress.
TEST(UniformStrain, ParallelToCutsIsReproducedAcrossThem) {
  test::Random random(63);
  const GridSettings bar = {{6, 3, 3}, Vec3(1, 0.5, 0.5), Vec3::Zero()};
  for (int run = 0; run < 4; ++run) {
    const bool jitter = run % 2;
    test::DeformedMesh cut(jitter ? test::jitteredGrid(bar, 0.2, &random) : gridMesh(bar));
    for (const Vec3& normal : {Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(0, 1, 0.4)})
      cut.cut(plane(Vec3(0, 0.23, 0.26), normal));
    cut.cut(rectangle(Vec3(0.5, 0.1, 0.1), Vec3(0, 1, -1), Vec3::UnitX(), 0.6, 0.3));
    const Materials materials(cut.mesh.mesh(), TISSUE);
    Assembly assembly(cut.mesh, materials, Mass::LUMPED, run < 2 ? Pressure::ELEMENT : Pressure::AVERAGED, false, 1);
    assembly.topologyChanged(cut.x);
    const double strain = 0.01, traction = TISSUE.young_modulus * strain;
    const Vec3 stretch(1 + strain, 1 - TISSUE.poisson_ratio * strain, 1 - TISSUE.poisson_ratio * strain);
    for (Vec3& x : cut.x) x = stretch.cwiseProduct(x);
    std::vector<Vec3> inner;
    assembly.elasticForces(cut.x, &inner);
    const Load right = {{Vec3(1 - 1e-9, -1, -1), Vec3(2, 2, 2)}, Vec3(traction, 0, 0), 0};
    const Load left = {{Vec3(-1, -1, -1), Vec3(1e-9, 2, 2)}, Vec3(-traction, 0, 0), 0};
    const std::vector<Vec3> on_right = loadForces(cut.mesh, right), on_left = loadForces(cut.mesh, left);
    for (std::size_t c = 0; c < inner.size(); ++c)
      EXPECT_LT((inner[c] - on_right[c] - on_left[c]).norm(), 1e-12 * traction) << "copy " << c;
    for (std::size_t p = 0; p < cut.mesh.parts().size(); ++p)
      EXPECT_LT(
          (assembly.stress(static_cast<int>(p), cut.x) - Vec3(traction, 0, 0).asDiagonal().toDenseMatrix()).norm(),
          1e-11 * traction);
  }
}

// Largest change of velocity among the copies of pieces that own copies right of `x`, and among the others.
std::pair<double, double> speeds(const DeformableBody& body, double x) {
  int count = 0;
  const std::vector<int> piece = body.mesh().copyPieces(&count);
  std::vector<bool> right(count, false);
  const auto& parts = body.mesh().parts();
  for (std::size_t p = 0; p < parts.size(); ++p) {
    double centre = 0;
    for (int I = 0; I < 4; ++I)
      centre += body.mesh().centroid(static_cast<int>(p))[I] *
                body.mesh().mesh().nodes[body.mesh().mesh().elements[parts[p].element][I]].x();
    if (centre > x) right[piece[parts[p].copies[0]]] = true;
  }
  double loaded = 0, other = 0;
  for (std::size_t c = 0; c < piece.size(); ++c) {
    double& largest = right[piece[c]] ? loaded : other;
    largest = std::max(largest, body.velocities()[c].norm());
  }
  return {loaded, other};
}

TEST(MovementIndependence, WhatPullsOnePieceLeavesTheOthersAtRest) {
  for (const auto& [mass, pressure] :
       {std::pair{Mass::LUMPED, Pressure::ELEMENT}, std::pair{Mass::CONSISTENT, Pressure::ELEMENT},
        std::pair{Mass::LUMPED, Pressure::AVERAGED}})
    for (Method method : {Method::DIRECT, Method::ITERATIVE}) {
      Scene scene = softBar();
      scene.body.mass = mass;
      scene.body.pressure = pressure;
      scene.solver.method = method;
      scene.loads = {{{Vec3(0.999, -1, -1), Vec3(2, 1, 1)}, Vec3(100, 20, 0), 0}};
      DeformableBody body = makeBody(scene);
      // Three planes in the same elements: two fragments between them hold no node.
      for (double x : {0.53, 0.55, 0.57}) EXPECT_EQ(body.cut(plane(Vec3(x, 0, 0), Vec3(1, 0.05, 0.03))).reason, "");
      ASSERT_EQ(body.counts().pieces, 4);
      for (int k = 0; k < 5; ++k) {
        body.step();
        const auto [loaded, other] = speeds(body, 0.6);
        EXPECT_GT(loaded, 0);
        EXPECT_LT(other, 1e-12 * loaded);
      }
    }
}

// Each piece's momentum is what the loads on its own skin give it, in particular a fragment's that holds no node.
TEST(MovementIndependence, APieceGainsTheMomentumOfItsOwnLoads) {
  for (Mass mass : {Mass::LUMPED, Mass::CONSISTENT}) {
    Scene scene = softBar();
    scene.body.mass = mass;
    scene.loads = {{{Vec3(-1, -1, 0.2499), Vec3(2, 1, 1)}, Vec3(30, 10, -50), 0}};
    DeformableBody body = makeBody(scene);
    const std::vector<double> cuts = {0.53, 0.55, 0.57};
    for (double x : cuts) body.cut(plane(Vec3(x, 0, 0), Vec3::UnitX()));
    ASSERT_EQ(body.counts().pieces, 4);
    const int steps = 10;
    test::run(&body, steps);

    int count = 0;
    const std::vector<int> piece = body.mesh().copyPieces(&count);
    const Materials materials(body.mesh().mesh(), scene.body.material);
    Assembly assembly(body.mesh(), materials, mass, Pressure::ELEMENT, true, 1);
    assembly.topologyChanged(body.positions());
    std::vector<Vec3> Mv;
    assembly.multiplyMass(body.velocities(), &Mv);
    std::vector<Vec3> momentum(count, Vec3::Zero());
    std::vector<double> masses(count, 0);
    for (std::size_t c = 0; c < Mv.size(); ++c) {
      momentum[piece[c]] += Mv[c];
      masses[piece[c]] += assembly.masses()[c];
    }
    std::vector<double> lengths;
    for (int k = 0; k < count; ++k) {
      const double length = masses[k] / (1000 * 0.25 * 0.25);
      lengths.push_back(length);
      const Vec3 expected = Vec3(30, 10, -50) * length * 0.25 * steps * scene.solver.time_step;
      EXPECT_LT((momentum[k] - expected).norm(), 1e-11 * expected.norm());
    }
    std::sort(lengths.begin(), lengths.end());
    EXPECT_NEAR(lengths[0], 0.02, 1e-12);
    EXPECT_NEAR(lengths[1], 0.02, 1e-12);
    EXPECT_NEAR(lengths[2], 0.43, 1e-12);
    EXPECT_NEAR(lengths[3], 0.53, 1e-12);
  }
}

TEST(FreeFlight, EveryPieceFallsAsOne) {
  Scene scene = softBar();
  scene.gravity = Vec3(1, 2, -9.81);
  DeformableBody body = makeBody(scene);
  test::Random random(64);
  for (int k = 0; k < 6; ++k) body.cut(random.plane(BAR));
  EXPECT_GT(body.counts().pieces, 6);
  test::run(&body, 20);
  const double t = body.time();
  for (std::size_t c = 0; c < body.velocities().size(); ++c)
    EXPECT_LT((body.velocities()[c] - t * scene.gravity).norm(), 1e-9 * t * scene.gravity.norm());
}

TEST(HeldCopies, ACutBesideAClampDropsTheLoosePiece) {
  Scene scene = softBar();
  scene.gravity = Vec3(0, 0, -9.81);
  scene.boundary = {clampLeftEnd()};
  DeformableBody body = makeBody(scene);
  body.cut(plane(Vec3(0.03, 0, 0), Vec3(1, 0.1, 0)));  // within the first layer of elements
  ASSERT_EQ(body.counts().pieces, 2);
  test::run(&body, 10);
  EXPECT_NEAR(speeds(body, 0.5).first, 9.81 * body.time(), 1e-9);
}

TEST(HeldCopies, BothSidesOfACutWithinHeldMaterialStay) {
  Scene scene = softBar();
  scene.gravity = Vec3(0, 0, -9.81);
  scene.boundary = {{{Vec3(-1, -1, -1), Vec3(2, 1, 1)}, Vec3::Zero()}};
  DeformableBody body = makeBody(scene);
  body.cut(plane(Vec3(0.47, 0, 0), Vec3(1, 0.1, 0.2)));
  EXPECT_EQ(body.counts().pieces, 2);
  test::run(&body, 3);
  for (const Vec3& v : body.velocities()) EXPECT_EQ(v.norm(), 0);
}

// The mesh of the bar in which nodes of a plane x = const, those chosen, are there twice: the left takes the second.
template <typename Chosen>
TetMesh withDuplicates(const TetMesh& mesh, double x, const Chosen& chosen) {
  TetMesh parted = mesh;
  std::map<int, int> twin;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    if (std::abs(mesh.nodes[n].x() - x) < 1e-9 && chosen(mesh.nodes[n])) {
      twin[static_cast<int>(n)] = static_cast<int>(parted.nodes.size());
      parted.nodes.push_back(mesh.nodes[n]);
    }
  for (auto& element : parted.elements) {
    double centre = 0;
    for (int n : element) centre += mesh.nodes[n].x() / 4;
    if (centre < x)
      for (int& n : element)
        if (const auto other = twin.find(n); other != twin.end()) n = other->second;
  }
  return parted;
}

void expectSameMotion(const PlaneCut& cut, const TetMesh& whole, const TetMesh& parted, const Scene& scene) {
  DeformableBody severed(scene, whole), duplicated(scene, parted);
  ASSERT_EQ(severed.cut(cut).status, CutStatus::APPLIED);
  ASSERT_EQ(severed.counts().parts, severed.counts().elements);
  ASSERT_EQ(severed.counts().copies, duplicated.counts().copies);
  test::run(&severed, 40);
  test::run(&duplicated, 40);
  // Own copies are those on the positive side, which kept their node. The others, by node, are the twins.
  std::vector<Vec3> moved = severed.nodePositions();
  for (std::size_t n = whole.nodes.size(); n < parted.nodes.size(); ++n)
    for (int c = 0; c < severed.mesh().numCopies(); ++c) {
      const int node = severed.mesh().copyNode(c);
      if (c != severed.mesh().ownCopy(node) && whole.nodes[node] == parted.nodes[n])
        moved.push_back(severed.positions()[c]);
    }
  EXPECT_LT(test::largestDifference(moved, duplicated.nodePositions()), 1e-10);
}

TEST(ACutAlongFaces, EqualsTheMeshWithDuplicatedNodes) {
  Scene scene = softBar();
  scene.gravity = Vec3(0, 2, -9.81);
  scene.boundary = {clampLeftEnd()};
  const TetMesh bar = gridMesh(BAR);
  const auto all = [](const Vec3&) { return true; };
  expectSameMotion(plane(Vec3(0.5, 0, 0), Vec3::UnitX()), bar, withDuplicates(bar, 0.5, all), scene);
  // Down to half the height, where the crack's front stays whole.
  const auto upper = [](const Vec3& X) { return X.z() > 0.126; };
  const PlaneCut notch = rectangle(Vec3(0.5, 0.125, 0.25), Vec3::UnitX(), Vec3::UnitZ(), 0.25, 1);
  expectSameMotion(notch, bar, withDuplicates(bar, 0.5, upper), scene);
}

TEST(ACutAlongFaces, EqualsTheMeshWithDuplicatedNodesAtTheClampToo) {
  Scene scene = softBar();
  scene.gravity = Vec3(0, 2, -9.81);
  scene.boundary = {{{Vec3(-1, -1, -1), Vec3(2, 1, 1e-6)}, Vec3::Zero()}};
  const TetMesh bar = gridMesh(BAR);
  const auto all = [](const Vec3&) { return true; };
  expectSameMotion(plane(Vec3(0.5, 0, 0), Vec3::UnitX()), bar, withDuplicates(bar, 0.5, all), scene);
}

TEST(Surface, OfACutBodyInMotionIsClosedAndEnclosesItsParts) {
  DeformableBody body = makeBody(cutInMotion(Method::DIRECT, 1));
  for (int k = 0; k < 30; ++k) {
    body.step();
    if (k % 5) continue;
    const auto positions = surfacePositions(body.surface(), body.positions());
    test::expectClosed(body.surface());
    EXPECT_NEAR(enclosedVolume(body.surface(), positions), test::filledVolume(body.mesh(), body.positions()), 1e-13);
  }
  double rest = 0;
  for (double volume : body.pieceVolumes()) rest += volume;
  EXPECT_NEAR(rest, 0.0625, 1e-12 * 0.0625);
}

}  // namespace
}  // namespace incision
