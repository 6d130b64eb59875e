#include "report/locking/tissue.h"

#include <map>
#include "report/locking/patches_try.h"
#include <numeric>

namespace incision::report {
namespace {

RigSettings settingsOf(const Problem& problem) {
  RigSettings settings = statics(YOUNG_MODULUS, 0);
  settings.conditions = {Vec3::Zero(), problem.holds, problem.loads};
  return settings;
}

Vector concatenated(const std::vector<Vec3>& values) {
  return Eigen::Map<const Vector>(values.front().data(), static_cast<Eigen::Index>(3 * values.size()));
}

}  // namespace

Sparse Tissue::matrix() const {
  if (D.rows() == 0) return K_0;
  const Sparse columns = D;
  return K_0 + Sparse(columns.transpose() * W.asDiagonal() * columns);
}

Specimen::Specimen(const Problem& problem, TetMesh mesh, const std::vector<PlaneCut>& cuts)
    : problem_(problem), rig_(std::move(mesh), settingsOf(problem)) {
  for (const PlaneCut& cut : cuts) rig_.cut(cut);
  free_ = rig_.freeCopies();
  select_.resize(3 * rig_.mesh.numCopies(), freedoms());
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < free_.size(); ++k)
    for (int i = 0; i < 3; ++i) entries.emplace_back(3 * free_[k] + i, 3 * k + i, 1);
  select_.setFromTriplets(entries.begin(), entries.end());
}

Tissue Specimen::tissue(double poisson_ratio, Averaging averaging) const {
  const Material whole{YOUNG_MODULUS, poisson_ratio, 1, 0, 0};
  const Material base{2 * whole.mu() * (1 + BASE_RATIO), BASE_RATIO, 1, 0, 0};
  const bool plain = averaging == Averaging::NONE;
  Assembly assembly(rig_.mesh, plain ? whole : base, Mass::LUMPED, false, 1);
  assembly.topologyChanged(rig_.motion.x);

  const Sparse K = systemMatrix(assembly, {0, 1}, allCopies(rig_.mesh));
  const Vector u_held = heldDisplacements();
  Tissue t;
  Vector forces = Vector::Zero(K.rows());
  for (const std::vector<Vec3>& load : loadForces(rig_.mesh, problem_.loads)) forces += concatenated(load);
  Vector K_u = K * u_held;
  t.K_0 = select_.transpose() * K * select_;
  if (!plain) {
    Vector volumes;
    const Sparse D = meanDilatations(averaging, &volumes);
    t.W = (whole.lambda() - base.lambda()) * volumes;
    t.D = D * select_;
    K_u += D.transpose() * (t.W.asDiagonal() * (D * u_held)).eval();
  }
  t.f = select_.transpose() * (forces - K_u);
  t.work_of_held = u_held.dot(K_u);
  return t;
}

Vector Specimen::heldDisplacements() const {
  std::vector<Vec3> u(rig_.mesh.numCopies(), Vec3::Zero());
  for (std::size_t c = 0; c < u.size(); ++c)
    if (rig_.step.held()[c] >= 0) u[c] = problem_.holds[rig_.step.held()[c]].velocity;
  return concatenated(u);
}

/// Parts of a cell that cracks sever from each other average by themselves.
std::vector<int> Specimen::cellOfParts(int* count) const {
  const std::vector<Part>& parts = rig_.mesh.parts();
  std::vector<int> link(parts.size());
  std::iota(link.begin(), link.end(), 0);
  const auto root = [&](int p) {
    while (link[p] != p) p = link[p];
    return p;
  };
  int np; const std::vector<int> patch=edgePatches(rig_.mesh.mesh(),MODE,&np);
  for (int e = 0; e < static_cast<int>(rig_.mesh.mesh().elements.size()); ++e)
    for (int face = 0; face < 4; ++face)
      for (const FacePair& pair : rig_.mesh.facePairs(e, face))
        if (!pair.severed && patch[parts[pair.other].element] == patch[e]) link[root(pair.part)] = root(pair.other);
  std::map<int, int> cell_of_root;
  std::vector<int> cells;
  for (int p = 0; p < static_cast<int>(parts.size()); ++p)
    cells.push_back(cell_of_root.try_emplace(root(p), static_cast<int>(cell_of_root.size())).first->second);
  *count = static_cast<int>(cell_of_root.size());
  return cells;
}

Sparse Specimen::meanDilatations(Averaging averaging, Vector* volumes) const {
  const Assembly& assembly = rig_.step.assembly();
  const CutMesh& mesh = rig_.mesh;
  int count = mesh.numCopies();
  std::vector<int> cells;
  if (averaging == Averaging::CELLS) cells = cellOfParts(&count);
  *volumes = Vector::Zero(count);
  std::vector<Eigen::Triplet<double>> entries;
  const auto add = [&](int c, int p, double share) {
    const Gradients g = assembly.rotatedGradients(p);
    (*volumes)[c] += share * assembly.volume(p);
    for (int J = 0; J < 4; ++J)
      for (int i = 0; i < 3; ++i)
        entries.emplace_back(c, 3 * mesh.parts()[p].copies[J] + i, share * assembly.volume(p) * g(i, J));
  };
  for (int p = 0; p < static_cast<int>(mesh.parts().size()); ++p) {
    if (averaging == Averaging::CELLS)
      add(cells[p], p, 1);
    else
      for (int copy : mesh.parts()[p].copies) add(copy, p, 0.25);
  }
  Sparse D(count, 3 * mesh.numCopies());
  D.setFromTriplets(entries.begin(), entries.end());
  return volumes->cwiseInverse().asDiagonal() * D;
}

double Specimen::answer(const Tissue& tissue, const Vector& u) const {
  if (problem_.plate()) {
    double moved = 0;
    for (const Hold& hold : problem_.holds) moved += hold.velocity.norm();
    return (tissue.work_of_held - tissue.f.dot(u)) / moved;
  }
  Vec3 force = Vec3::Zero();
  const std::vector<Vec3> forces = loadForces(rig_.mesh, problem_.loads).front();
  for (const Vec3& f : forces) force += f;
  return tissue.f.dot(u) / force.norm();
}

double Specimen::dilatation(const Vector& u) const {
  const Vector all = heldDisplacements() + select_ * u;
  const Assembly& assembly = rig_.step.assembly();
  double gained = 0, volume = 0;
  for (int p = 0; p < static_cast<int>(rig_.mesh.parts().size()); ++p) {
    const Gradients g = assembly.rotatedGradients(p);
    volume += assembly.volume(p);
    for (int J = 0; J < 4; ++J)
      gained += assembly.volume(p) * g.col(J).dot(all.segment<3>(3 * rig_.mesh.parts()[p].copies[J]));
  }
  return gained / volume;
}

}  // namespace incision::report
