#include "incision/fem/tension.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "incision/base/parallel.h"

namespace incision {
namespace {

/// What sways up are waves over many elements: of large bodies one part of so many is looked at.
constexpr int EVERY = 8, FEW = 128;

/// What Δt σ / (h √(E ρ)) has to be in the mean, or half of σ/E: what is stretched to twice its length hardly
/// resists a turn by itself.
constexpr double MEAN_PULL = 0.5;

}  // namespace

Tension::Tension(const Assembly& assembly) : assembly_(assembly) {
  const Materials& materials = assembly.materials();
  for (int e = 0; e < static_cast<int>(assembly.mesh().mesh().elements.size()); ++e)
    impedance_.push_back(std::sqrt(materials.youngModulus(e) * materials.of(e).density));
}

void Tension::topologyChanged(const std::vector<int>& piece, int pieces, const std::vector<int>& held) {
  acts_ = false;
  piece_held_.assign(static_cast<std::size_t>(pieces), 0);
  for (std::size_t c = 0; c < piece.size(); ++c)
    if (held[c] >= 0) piece_held_[static_cast<std::size_t>(piece[c])] = 1;
  any_held_ = assembly_.warping() && std::find(piece_held_.begin(), piece_held_.end(), 1) != piece_held_.end();
  if (!any_held_) return;
  const std::vector<Part>& parts = assembly_.mesh().parts();
  part_piece_.resize(parts.size());
  parallelFor(static_cast<int>(parts.size()), assembly_.threads(), [&](int p) {
    const int of_part = piece[static_cast<std::size_t>(parts[p].copies[0])];
    part_piece_[p] = piece_held_[of_part] ? of_part : -1;
  });
  findThickness(piece);
  part_acts_.reserve(parts.size());
  products_.reserve(parts.size());
}

/// That of a plate with the least of the pieces' moments Σ m (X − c)(X − c)ᵀ / m at rest.
void Tension::findThickness(const std::vector<int>& piece) {
  const CutMesh& mesh = assembly_.mesh();
  struct Sums {
    double mass = 0;
    Vec3 first = Vec3::Zero();
    Mat3 second = Mat3::Zero();
  };
  std::vector<Sums> sums(piece_held_.size());
  const Vec3 origin = mesh.mesh().nodes[0];
  for (int c = 0; c < mesh.numCopies(); ++c) {
    const auto of_copy = static_cast<std::size_t>(piece[static_cast<std::size_t>(c)]);
    if (!piece_held_[of_copy]) continue;
    const double mass = assembly_.masses()[c];
    const Vec3 X = mesh.mesh().nodes[mesh.copyNode(c)] - origin;
    sums[of_copy].mass += mass;
    sums[of_copy].first += mass * X;
    sums[of_copy].second += mass * X * X.transpose();
  }
  piece_thickness_.clear();
  for (const Sums& sum : sums) {
    const Vec3 mean = sum.first / sum.mass;
    const Mat3 spread = sum.second / sum.mass - mean * mean.transpose();
    const double least = Eigen::SelfAdjointEigenSolver<Mat3>(spread, Eigen::EigenvaluesOnly).eigenvalues()[0];
    piece_thickness_.push_back(std::sqrt(12 * std::max(least, 0.0)));
  }
}

void Tension::find(TensionScheme scheme, double time_step, const std::vector<Vec3>& x) {
  acts_ = false;
  if (!any_held_ || scheme == TensionScheme::EXPLICIT) return;
  piece_acts_ = piece_held_;
  if (scheme == TensionScheme::AUTO) choosePieces(time_step, x);
  acts_ = std::find(piece_acts_.begin(), piece_acts_.end(), 1) != piece_acts_.end();
  if (!acts_) return;
  part_acts_.resize(part_piece_.size());
  parallelFor(static_cast<int>(part_piece_.size()), assembly_.threads(),
              [&](int p) { part_acts_[p] = part_piece_[p] >= 0 && piece_acts_[part_piece_[p]]; });
  assembly_.tensionProducts(x, time_step * time_step, part_acts_, &products_);
}

/// By what the largest stress of a part can be at most, to its invariants.
void Tension::choosePieces(double time_step, const std::vector<Vec3>& x) {
  const int parts = static_cast<int>(part_piece_.size()), every = std::clamp(parts / FEW, 1, EVERY);
  pulls_.resize(static_cast<std::size_t>((parts + every - 1) / every));
  parallelFor(static_cast<int>(pulls_.size()), assembly_.threads(), [&](int i) {
    const int p = every * i, of_part = part_piece_[p];
    if (of_part < 0) return;
    const Mat3 S = assembly_.unrotatedStress(p, x);
    const double t = S.trace(), around = (S - t / 3 * Mat3::Identity()).squaredNorm();
    const double most = std::max(t / 3 + std::sqrt(2 * around / 3), 0.0);
    const int element = assembly_.mesh().parts()[p].element;
    const double limp = MEAN_PULL * most / assembly_.materials().youngModulus(element);
    pulls_[i] = std::max(time_step * most / (piece_thickness_[of_part] * impedance_[element]), limp);
  });
  means_.assign(piece_held_.size(), Mean());
  for (std::size_t i = 0; i < pulls_.size(); ++i) {
    const int of_part = part_piece_[static_cast<std::size_t>(every) * i];
    if (of_part < 0) continue;
    means_[of_part].sum += pulls_[i];
    ++means_[of_part].count;
  }
  for (std::size_t piece = 0; piece < means_.size(); ++piece)
    piece_acts_[piece] = means_[piece].sum > MEAN_PULL * means_[piece].count;
}

}  // namespace incision
