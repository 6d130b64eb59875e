#include "incision/solver/couplers.h"

#include <algorithm>

namespace incision {

Couplers::Couplers(std::vector<Coupler*> list) : list_(std::move(list)), may_act_(list_.size(), false) {}

void Couplers::changed(const CutMesh& mesh) {
  for (Coupler* coupler : list_) coupler->changed(mesh);
}

bool Couplers::begin(const StepStart& start) {
  span_ = start.span;
  bool any = false;
  for (std::size_t i = 0; i < list_.size(); ++i) {
    may_act_[i] = list_[i]->begin(start);
    any = any || may_act_[i];
  }
  return any;
}

bool Couplers::update(const std::vector<Vec3>& v_end) {
  springs_.clear();
  bool differ = false;
  for (std::size_t i = 0; i < list_.size(); ++i) {
    if (!may_act_[i]) continue;
    const std::size_t first = springs_.size();
    if (list_[i]->update(span_, v_end, &springs_)) differ = true;
    for (std::size_t s = first; s < springs_.size(); ++s) springs_[s].coupler = static_cast<int>(i);
  }
  return differ;
}

void Couplers::findWrenches(const std::vector<Vec3>& x, const std::vector<Vec3>& v_end,
                            std::vector<Wrench>* wrenches) const {
  wrenches->assign(list_.size(), Wrench());
  for (const Spring& spring : springs_) {
    if (!list_[static_cast<std::size_t>(spring.coupler)]->hasOtherEnd()) continue;
    Wrench& sum = (*wrenches)[static_cast<std::size_t>(spring.coupler)];
    const Wrench one = wrenchOf(spring, span_.time_step, x, v_end);
    sum.force += one.force;
    sum.torque += one.torque;
  }
}

void Couplers::accept(const Motion& end, const std::vector<Wrench>& felt) {
  for (std::size_t i = 0; i < list_.size(); ++i)
    if (may_act_[i]) list_[i]->accept(span_, end, felt[i]);
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
  for (const Coupler* coupler : list_) kept.push_back(coupler->keep());
  return kept;
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
