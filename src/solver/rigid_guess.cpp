#include "incision/solver/rigid_guess.h"

#include <Eigen/Geometry>
#include <cmath>

namespace incision {
namespace {

constexpr int MAX_ITERATIONS = 100;

/// A guess need not be better than this: a spring's force may still change by this share of the largest.
constexpr double GOOD_ENOUGH = 1e-2;

constexpr double SEARCH_TOLERANCE = 0.05;
constexpr int MAX_SEARCH = 20;

Mat3 crossMatrix(const Vec3& a) { return (Mat3() << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0).finished(); }

}  // namespace

void RigidGuess::find(const RigidPieces& rigid, double time_step, const std::vector<Vec3>& x,
                      const std::vector<Vec3>& driving, Couplers* couplers, std::vector<Vec3>* moved) {
  iterations_ = 0;
  findEnds(rigid, x, couplers->springs());
  if (piece_.empty()) return;
  driveBy(rigid, x, driving);
  q_ = Eigen::VectorXd::Zero(drive_.size());
  way_.resize(moved->size());
  tried_.resize(moved->size());
  couplers->takeBounds(*moved);
  couplers->update(*moved);
  for (; iterations_ < MAX_ITERATIONS;) {
    ++iterations_;
    const std::vector<Spring>& springs = couplers->springs();
    assemble(time_step, springs, *moved);
    step_ = matrix_.ldlt().solve(right_);
    for (std::size_t i = 0; i < springs.size(); ++i) {
      way_[i].setZero();
      for (const End& end : ends_[static_cast<int>(i)])
        way_[i] += time_step * (end.a * step_.segment<3>(end.unknown) + Vec3(step_.segment<3>(end.unknown + 3)).cross(end.b));
    }
    // expected forces
    double largest = 0, off = 0;
    for (std::size_t i = 0; i < springs.size(); ++i) tried_[i] = springs[i].at((*moved)[i] + way_[i]);
    const std::vector<Vec3> expected = tried_;
    const double slope = step_.dot(drive_ - mass_ * q_), curvature = step_.dot(mass_ * step_);
    double here = 0, bend = 0;
    const auto trial = [&](double share) {
      for (std::size_t i = 0; i < way_.size(); ++i) tried_[i] = (*moved)[i] + share * way_[i];
      couplers->update(tried_);
      here = slope - share * curvature;
      bend = curvature;
      for (std::size_t i = 0; i < way_.size(); ++i) {
        here += way_[i].dot(springs[i].at(tried_[i]));
        bend += way_[i].dot(springs[i].stiffness * way_[i]);
      }
    };
    trial(0);
    const double at_start = here;
    double near = 0, far = 1, share = 1;
    trial(1);
    for (int k = 0; k < MAX_SEARCH && (k > 0 || here < 0) && std::abs(here) > SEARCH_TOLERANCE * at_start; ++k) {
      (here > 0 ? near : far) = share;
      const double newton = share + here / bend;
      share = newton > near && newton < far ? newton : (near + far) / 2;
      trial(share);
    }
    q_ += share * step_;
    for (std::size_t i = 0; i < way_.size(); ++i) (*moved)[i] += share * way_[i];
    couplers->takeBounds(*moved);
    couplers->update(*moved);
    for (std::size_t i = 0; i < way_.size(); ++i) {
      const Vec3 force = springs[i].at((*moved)[i]);
      largest = std::max(largest, force.squaredNorm());
      off = std::max(off, (force - expected[i]).squaredNorm());
    }
    if (share == 1 && off <= GOOD_ENOUGH * GOOD_ENOUGH * largest) break;
  }
}

void RigidGuess::addTo(const RigidPieces& rigid, const std::vector<Vec3>& x, std::vector<Vec3>* dv) const {
  if (piece_.empty()) return;
  for (std::size_t c = 0; c < x.size(); ++c) {
    const int piece = rigid.pieceOf(c), at = unknown_[static_cast<std::size_t>(piece)];
    if (at < 0) continue;
    (*dv)[c] += Vec3(q_.segment<3>(at)) + Vec3(q_.segment<3>(at + 3)).cross(x[c] - rigid.centreOf(piece));
  }
}

void RigidGuess::findEnds(const RigidPieces& rigid, const std::vector<Vec3>& x, const std::vector<Spring>& springs) {
  unknown_.assign(rigid.pieces(), -1);
  piece_.clear();
  ends_.clear();
  for (const Spring& spring : springs) {
    for (int k = 0; k < spring.count; ++k) {
      const int copy = spring.copies[k], piece = rigid.pieceOf(copy);
      if (!rigid.isFree(copy)) continue;
      int& unknown = unknown_[static_cast<std::size_t>(piece)];
      if (unknown < 0) {
        unknown = 6 * static_cast<int>(piece_.size());
        piece_.push_back(piece);
      }
      Span<End> ends = ends_.unfinished();
      int at = 0;
      while (at < ends.size() && ends[at].unknown != unknown) ++at;
      if (at == ends.size()) ends_.append({unknown, 0, Vec3::Zero()});
      End& end = ends_.unfinished()[at];
      end.a += spring.weights[k];
      end.b += spring.weights[k] * (x[copy] - rigid.centreOf(piece));
    }
    ends_.finish();
  }
}

void RigidGuess::driveBy(const RigidPieces& rigid, const std::vector<Vec3>& x, const std::vector<Vec3>& driving) {
  const int size = 6 * static_cast<int>(piece_.size());
  mass_ = Eigen::MatrixXd::Zero(size, size);
  drive_ = Eigen::VectorXd::Zero(size);
  for (std::size_t k = 0; k < piece_.size(); ++k) {
    const int at = 6 * static_cast<int>(k);
    mass_.block<3, 3>(at, at) = rigid.massOf(piece_[k]) * Mat3::Identity();
    mass_.block<3, 3>(at + 3, at + 3) = rigid.inertiaOf(piece_[k]);
  }
  for (std::size_t c = 0; c < x.size(); ++c) {
    const int piece = rigid.pieceOf(c), at = unknown_[static_cast<std::size_t>(piece)];
    if (at < 0) continue;
    drive_.segment<3>(at) += driving[c];
    drive_.segment<3>(at + 3) += (x[c] - rigid.centreOf(piece)).cross(driving[c]);
  }
}

void RigidGuess::assemble(double time_step, const std::vector<Spring>& springs, const std::vector<Vec3>& moved) {
  matrix_ = mass_;
  right_ = drive_ - mass_ * q_;
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const Spring& spring = springs[i];
    const Vec3 impulse = time_step * spring.at(moved[i]);
    for (const End& end : ends_[static_cast<int>(i)]) {
      right_.segment<3>(end.unknown) += end.a * impulse;
      right_.segment<3>(end.unknown + 3) += end.b.cross(impulse);
    }
    if (!spring.isStiff()) continue;
    const Mat3 K = time_step * time_step * spring.stiffness;
    for (const End& end : ends_[static_cast<int>(i)]) {
      const Mat3 shift = end.a * K, turn = crossMatrix(end.b) * K;
      for (const End& other : ends_[static_cast<int>(i)]) {
        const Mat3 arms = crossMatrix(other.b);
        matrix_.block<3, 3>(end.unknown, other.unknown) += other.a * shift;
        matrix_.block<3, 3>(end.unknown, other.unknown + 3) -= shift * arms;
        matrix_.block<3, 3>(end.unknown + 3, other.unknown) += other.a * turn;
        matrix_.block<3, 3>(end.unknown + 3, other.unknown + 3) -= turn * arms;
      }
    }
  }
}

}  // namespace incision
