#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <random>
#include <vector>

#include "incision/fem/block_matrix.h"
#include "incision/mesh/grid_mesh.h"
#include "incision/solver/implicit_step.h"
#include "support/cuts.h"

namespace incision {

/// A block of cells with its smallest corner at `origin`.
inline TetMesh block(const std::array<int, 3>& cells, const Vec3& size, const Vec3& origin = Vec3::Zero()) {
  return gridMesh({cells, size, origin});
}

/// The nodes at one value of a coordinate; of a body of some metres.
inline RestBox slab(int axis, double at) {
  RestBox box{Vec3::Constant(-1e3), Vec3::Constant(1e3)};
  box.min[axis] = at - 1e-9;
  box.max[axis] = at + 1e-9;
  return box;
}

inline std::vector<Vec3> restPositions(const CutMesh& mesh) {
  std::vector<Vec3> X;
  for (int c = 0; c < mesh.numCopies(); ++c) X.push_back(mesh.mesh().nodes[mesh.copyNode(c)]);
  return X;
}

/// Vectors with components in [−size, size].
inline std::vector<Vec3> randomVectors(std::size_t count, double size, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-size, size);
  std::vector<Vec3> vectors(count);
  for (Vec3& v : vectors)
    for (int i = 0; i < 3; ++i) v[i] = uniform(generator);
  return vectors;
}

/// Largest |a_c − b_c|.
inline double largestDifference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = 0;
  for (std::size_t c = 0; c < a.size(); ++c) largest = std::max(largest, (a[c] - b[c]).norm());
  return largest;
}

inline double largest(const std::vector<Vec3>& a) {
  return largestDifference(a, std::vector<Vec3>(a.size(), Vec3::Zero()));
}

/// mass M + stiffness K over the listed copies, as the solvers get it.
inline Eigen::SparseMatrix<double> systemMatrix(const Assembly& assembly, const SystemFactors& factors,
                                                const std::vector<int>& copies) {
  BlockPattern pattern;
  findPattern(assembly, copies, &pattern);
  std::vector<double> blocks;
  BlockAssembler<double>().assemble(assembly, pattern, factors, std::vector<double>(copies.size(), 1), &blocks);
  std::vector<Eigen::Triplet<double>> entries;
  for (int r = 0; r < pattern.rows(); ++r)
    for (int k = pattern.row_start[r]; k < pattern.row_start[r + 1]; ++k)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          entries.emplace_back(3 * r + i, 3 * pattern.column[k] + j, blocks[BLOCK_SIZE * k + 3 * j + i]);
  const int size = 3 * pattern.rows();
  Eigen::SparseMatrix<double> A(size, size);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

inline std::vector<int> allCopies(const CutMesh& mesh) {
  std::vector<int> copies;
  for (int c = 0; c < mesh.numCopies(); ++c) copies.push_back(c);
  return copies;
}

/// What a rig is made of: a soft block in empty space unless told otherwise.
struct RigSettings {
  Material material;
  Mass mass = Mass::LUMPED;
  Pressure pressure = Pressure::ELEMENT;
  bool warping = true;
  BoundaryConditions conditions;
  SolverSettings solver = {0.01, Method::DIRECT, 1e-6, 1};
  std::vector<RegionSettings> regions = {};
};

/// A body whose positions and velocities a test may set.
class Rig {
 public:
  Rig(TetMesh rest, const RigSettings& settings)
      : mesh(std::move(rest)),
        materials(mesh.mesh(), settings.material, settings.regions),
        step(mesh, materials, settings.mass, settings.pressure, settings.warping, settings.conditions, settings.solver),
        time_step(settings.solver.time_step) {
    motion.x = restPositions(mesh);
    motion.v.assign(motion.x.size(), Vec3::Zero());
    step.topologyChanged(motion);
  }

  Rig(const Rig&) = delete;  // the step refers to the mesh

  Insertion cut(const PlaneCut& plane) { return cut(planeField(plane, mesh, motion.x)); }

  Insertion cut(const CrackField& crack) {
    const Insertion done = mesh.insert(crack);
    for (int c = static_cast<int>(motion.x.size()); c < mesh.numCopies(); ++c) {
      motion.x.push_back(motion.x[mesh.copyParent(c)]);
      motion.v.push_back(motion.v[mesh.copyParent(c)]);
    }
    step.topologyChanged(motion, done.touched);
    return done;
  }

  /// Returns whether the step could be taken.
  bool advance() {
    step.begin(time_step, motion);
    const bool done = step.advance(time, &motion);
    time += time_step;
    return done;
  }

  int pieces() const {
    int count = 0;
    mesh.copyPieces(&count);
    return count;
  }

  std::vector<int> freeCopies() const {
    std::vector<int> copies;
    for (int c = 0; c < mesh.numCopies(); ++c)
      if (step.held()[c] < 0) copies.push_back(c);
    return copies;
  }

  std::vector<Vec3> displacements() const {
    std::vector<Vec3> u = restPositions(mesh);
    for (std::size_t c = 0; c < u.size(); ++c) u[c] = motion.x[c] - u[c];
    return u;
  }

  Vec3 momentum() const {
    std::vector<Vec3> Mv;
    step.assembly().multiplyMass(motion.v, &Mv);
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : Mv) sum += p;
    return sum;
  }

  double kineticEnergy() const {
    std::vector<Vec3> Mv;
    step.assembly().multiplyMass(motion.v, &Mv);
    double sum = 0;
    for (std::size_t c = 0; c < Mv.size(); ++c) sum += 0.5 * Mv[c].dot(motion.v[c]);
    return sum;
  }

  double energy() const { return kineticEnergy() + step.assembly().elasticEnergy(motion.x); }

  CutMesh mesh;
  Materials materials;
  ImplicitStep step;
  Motion motion;
  double time = 0, time_step;
};

/// Settings under which one step from rest gives the static answer: a long step of a body so light that its inertia
/// does not show, without warping.
inline RigSettings statics(double young_modulus, double poisson_ratio) {
  RigSettings settings;
  settings.material = {young_modulus, poisson_ratio, 1e-12, 0, 0};
  settings.warping = false;
  settings.solver.time_step = 1;
  return settings;
}

}  // namespace incision
