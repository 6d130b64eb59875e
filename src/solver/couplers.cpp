#include "incision/solver/couplers.h"

#include <algorithm>
#include <cmath>

namespace incision {
namespace {

/// What springs do beside the straight ways, as a share of what they do along them: in contact friction takes more than
/// this away. It is lost in rounding where the ways are shorter than this share of the largest coordinate.
constexpr double MOST_BESIDE = 0.3, SHORT_WAY = 1e-9;

}  // namespace

Couplers::Couplers(std::vector<Coupler*> list)
    : list_(std::move(list)), takes_part_(list_.size(), false), first_(list_.size() + 1, 0) {}

void Couplers::changed(const CutMesh& mesh) {
  for (Coupler* coupler : list_) coupler->changed(mesh);
}

bool Couplers::begin(const StepStart& start) {
  span_ = start.span;
  springs_.clear();
  bool any = false;
  for (std::size_t i = 0; i < list_.size(); ++i) {
    takes_part_[i] = list_[i]->begin(start, &springs_);
    if (!takes_part_[i]) springs_.resize(first_[i]);
    any = any || takes_part_[i];
    first_[i + 1] = springs_.size();
    for (std::size_t s = first_[i]; s < first_[i + 1]; ++s) springs_[s].coupler = static_cast<int>(i);
  }
  return any;
}

void Couplers::takeBounds(const std::vector<Vec3>& moved) {
  whole_way_.assign(moved.size(), 1);
  takeBounds(moved, whole_way_);
}

void Couplers::takeBounds(const std::vector<Vec3>& moved, const std::vector<double>& share) {
  for (std::size_t i = 0; i < list_.size(); ++i)
    if (takes_part_[i]) list_[i]->takeBounds(ofCoupler(i, moved), ofCoupler(i, share));
}

void Couplers::update(const std::vector<Vec3>& moved) {
  for (std::size_t i = 0; i < list_.size(); ++i)
    if (takes_part_[i])
      list_[i]->update(ofCoupler(i, moved), {springs_.data() + first_[i], springs_.data() + first_[i + 1]});
}

double Couplers::looseness() const {
  double least = 1;
  for (std::size_t i = 0; i < list_.size(); ++i)
    if (takes_part_[i]) least = std::min(least, list_[i]->looseness());
  return least;
}

void Couplers::findWrenches(const std::vector<Vec3>& impulses, const std::vector<Vec3>& y,
                            std::vector<Wrench>* wrenches) const {
  wrenches->assign(list_.size(), Wrench());
  for (std::size_t i = 0; i < list_.size(); ++i) {
    if (!list_[i]->hasOtherEnd()) continue;
    for (std::size_t s = first_[i]; s < first_[i + 1]; ++s) {
      const Wrench one = wrenchOf(impulses[s] / span_.time_step, y[s]);
      (*wrenches)[i].force += one.force;
      (*wrenches)[i].torque += one.torque;
    }
  }
}

bool Couplers::hold(const std::vector<Vec3>& moved, const Motion& end) {
  for (std::size_t i = 0; i < list_.size(); ++i)
    if (takes_part_[i] && !list_[i]->holds(span_, ofCoupler(i, moved), end)) return false;
  return true;
}

bool Couplers::driveOn(const std::vector<Vec3>& impulses, const std::vector<Vec3>& moved,
                       const std::vector<Vec3>& start, const std::vector<Vec3>& end) const {
  double along = 0, beside = 0, all = 0;
  for (std::size_t i = 0; i < list_.size(); ++i) {
    if (list_[i]->hasOtherEnd()) continue;
    for (std::size_t s = first_[i]; s < first_[i + 1]; ++s) {
      if (impulses[s].isZero(0)) continue;
      const Vec3 way = weightedSum(springs_[s], end) - weightedSum(springs_[s], start);
      along += std::abs(impulses[s].dot(moved[s]));
      beside += impulses[s].dot(way - moved[s]);
      all += impulses[s].norm();
    }
  }
  if (beside <= MOST_BESIDE * along) return false;
  double reach = 0;
  for (const Vec3& x : end) reach = std::max(reach, x.cwiseAbs().maxCoeff());
  return beside > SHORT_WAY * reach * all;
}

void Couplers::accept(const std::vector<Vec3>& moved, const Motion& end, const std::vector<Wrench>& felt) {
  for (std::size_t i = 0; i < list_.size(); ++i)
    if (takes_part_[i]) list_[i]->accept(span_, ofCoupler(i, moved), end, felt[i]);
}

void Couplers::stepFailed() {
  for (Coupler* coupler : list_) coupler->stepFailed();
}

int Couplers::joinPieces(const CutMesh& mesh, int pieces, std::vector<int>* piece) const {
  DisjointSets sets(pieces);
  for (const Coupler* coupler : list_) coupler->joinPieces(mesh, *piece, &sets);
  std::vector<int> joined;
  const int count = sets.enumerate(&joined);
  for (int& p : *piece) p = joined[p];
  return count;
}

std::vector<std::any> Couplers::keep() const {
  std::vector<std::any> kept;
  keepIn(&kept);
  return kept;
}

void Couplers::keepIn(std::vector<std::any>* kept) const {
  kept->resize(list_.size());
  for (std::size_t i = 0; i < list_.size(); ++i) list_[i]->keepIn(&(*kept)[i]);
}

void Couplers::recall(const std::vector<std::any>& kept) {
  for (std::size_t i = 0; i < list_.size(); ++i) list_[i]->recall(kept[i]);
}

void Couplers::write(const std::vector<std::any>& kept, ArchiveWriter* archive) const {
  for (std::size_t i = 0; i < list_.size(); ++i) list_[i]->write(kept[i], archive);
}

std::vector<std::any> Couplers::read(ArchiveReader* archive) const {
  std::vector<std::any> kept;
  for (const Coupler* coupler : list_) kept.push_back(coupler->read(archive));
  return kept;
}

}  // namespace incision
