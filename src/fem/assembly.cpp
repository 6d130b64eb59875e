#include "incision/fem/assembly.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "incision/base/parallel.h"

namespace incision {
namespace {

Corner corner(int part, int node) { return {static_cast<unsigned>(part), static_cast<unsigned>(node)}; }

/// Roundings that add up in one force: of four products in F, three each in RᵀF, σ, Rσ and the force itself.
constexpr double ROUNDINGS = 16;

}  // namespace

Assembly::Assembly(const CutMesh& mesh, const Materials& materials, Mass mass, Pressure pressure, bool warping,
                   int threads)
    : mesh_(mesh), materials_(materials), mass_(mass), warping_(warping), threads_(threads) {
  const std::vector<RestElement> rest = restElements(mesh.mesh());
  for (std::size_t e = 0; e < rest.size(); ++e) elements_.push_back({rest[e], materials.lame(static_cast<int>(e))});
  // Room for cuts, or the first one would move these arrays, the largest but for the matrix.
  const std::size_t expected = mesh.parts().size() + mesh.parts().size() / 4;
  rotations_.reserve(expected);
  if (warping) found_rotations_.reserve(expected);
  if (pressure == Pressure::AVERAGED) patches_.emplace(mesh, materials.regions());
}

void Assembly::topologyChanged(const std::vector<Vec3>& x, const std::vector<int>& touched) {
  found_at_.clear();
  const std::vector<Part>& parts = mesh_.parts();
  const bool first = corners_.count() == 0;
  std::vector<char> is_touched(mesh_.mesh().nodes.size(), first);
  for (int node : touched) is_touched[node] = 1;
  findCorners(is_touched);
  if (patches_) patches_->topologyChanged(touched);

  const int copies = mesh_.numCopies();
  for (auto* sums : {&masses_, &mass_diagonal_, &stiffness_diagonal_, &force_rounding_}) sums->resize(copies);
  parallelFor(copies, threads_, [&](int c) {
    if (is_touched[mesh_.copyNode(c)]) sumCorners(c);
  });

  run_sums_.topologyChanged(parts, copies);
  const std::size_t known = rotations_.size();
  rotations_.resize(parts.size(), Mat3::Identity());
  if (!warping_) return;
  for (std::size_t p = known; p < parts.size(); ++p)
    rotations_[p] = polarRotation(gradientOf(static_cast<int>(p), x), rotations_[parts[p].element]);
}

/// Lists the corners of every copy by ascending part; those of untouched nodes keep theirs.
void Assembly::findCorners(const std::vector<char>& touched) {
  const MeshTopology& topology = mesh_.topology();
  const int copies = mesh_.numCopies();
  Lists<Corner> sorted;
  sorted.sort(copies, [&](const auto& add) {
    for (int c = 0; c < copies; ++c) {
      if (touched[mesh_.copyNode(c)]) continue;
      for (const Corner& corner : corners_[c]) add(c, corner);
    }
    for (int n = 0; n < topology.star.count(); ++n) {
      if (!touched[n]) continue;
      for (int e : topology.star[n]) {
        const auto& nodes = mesh_.mesh().elements[e];
        const int I = static_cast<int>(std::find(nodes.begin(), nodes.end(), n) - nodes.begin());
        for (int p = e; p >= 0; p = mesh_.parts()[p].next) add(mesh_.parts()[p].copies[I], corner(p, I));
      }
    }
  });
  corners_ = std::move(sorted);
  for (int c = 0; c < copies; ++c)
    if (touched[mesh_.copyNode(c)])
      std::sort(corners_[c].begin(), corners_[c].end(),
                [](const Corner& a, const Corner& b) { return a.part < b.part; });
}

// The trace of K_cc is V_p (λ + 4 μ) b_I·b_I for each corner. The rounding of a force: F is a sum of y_J b_Jᵀ that
// mostly cancel, so it has that of the largest, and the stress carries it on.
void Assembly::sumCorners(int c) {
  masses_[c] = mass_diagonal_[c] = stiffness_diagonal_[c] = force_rounding_[c] = 0;
  for (const Corner& corner : corners_[c]) {
    const int p = corner.part, I = corner.node;
    const auto& [lambda, mu] = lameOf(p);
    const Gradients b = elements_[mesh_.parts()[p].element].gradients();
    const double V = volume(p), largest = std::sqrt(b.colwise().squaredNorm().maxCoeff());
    masses_[c] += densityOf(p) * V * mesh_.centroid(p)[I];
    mass_diagonal_[c] += massProduct(p, I, I);
    stiffness_diagonal_[c] += V * (lambda + 4 * mu) / 3 * b.col(I).squaredNorm();
    force_rounding_[c] +=
        ROUNDINGS * std::numeric_limits<double>::epsilon() * (lambda + 2 * mu) * V * b.col(I).norm() * largest;
  }
}

void Assembly::markRotations() noexcept {
  rotated_ = false;
  marked_rotations_ = rotations_.size();
}

void Assembly::takeMarked(std::vector<Mat3>* marked) noexcept {
  if (rotated_) rotations_.swap(found_rotations_);
  rotated_ = false;
  marked->swap(rotations_);
  marked->resize(warping_ ? marked_rotations_ : 0);
  rotations_.clear();
}

const std::vector<Mat3>& Assembly::rotations() const {
  static const std::vector<Mat3> none;
  return warping_ ? rotations_ : none;
}

void Assembly::recallRotations(const std::vector<Mat3>& rotations) {
  found_at_.clear();
  if (!rotations.empty()) rotations_ = rotations;
}

void Assembly::reset() {
  rotations_.clear();
  found_at_.clear();
  if (patches_) patches_->reset();
  corners_.clear();
}

void Assembly::multiplyMass(const std::vector<Vec3>& w, std::vector<Vec3>* result) const {
  if (!consistentMass()) {
    result->resize(w.size());
    parallelFor(static_cast<int>(w.size()), threads_, [&](int c) { (*result)[c] = masses_[c] * w[c]; });
    return;
  }
  part_momenta_.resize(mesh_.parts().size());
  parallelFor(static_cast<int>(mesh_.parts().size()), threads_, [&](int p) {
    part_momenta_[p].setZero();
    for (int I = 0; I < 4; ++I)
      for (int J = 0; J < 4; ++J) part_momenta_[p].col(I) += massProduct(p, I, J) * w[mesh_.parts()[p].copies[J]];
  });
  gather([&](const Corner& corner) -> Vec3 { return part_momenta_[corner.part].col(corner.node); }, result);
}

/// Sums what the corners of every copy bring.
template <typename Function>
void Assembly::gather(const Function& atCorner, std::vector<Vec3>* result) const {
  result->resize(masses_.size());
  parallelFor(static_cast<int>(masses_.size()), threads_, [&](int c) {
    Vec3 sum = Vec3::Zero();
    for (const Corner& corner : corners_[c]) sum += atCorner(corner);
    (*result)[c] = sum;
  });
}

double Assembly::volume(int part) const {
  return mesh_.parts()[part].fraction * elements_[mesh_.parts()[part].element].volume;
}

double Assembly::patchVolume(int patch) const {
  double sum = 0;
  for (int p : patches_->parts()[patch]) sum += volume(p);
  return sum;
}

Gradients Assembly::rotatedGradients(int part) const {
  return rotations_[part] * elements_[mesh_.parts()[part].element].gradients();
}

double Assembly::massProduct(int part, int I, int J) const {
  const double element_mass = densityOf(part) * elements_[mesh_.parts()[part].element].volume;
  if (mesh_.parts()[part].detail < 0) return element_mass * (I == J ? 2 : 1) / 20;
  return element_mass * mesh_.detail(part).products(I, J);
}

}  // namespace incision
