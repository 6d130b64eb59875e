#include "incision/tool/near_parts.h"

#include <algorithm>

#include "incision/tool/part_frame.h"

namespace incision {
namespace {

/// Elements in a run: fewer, and there are as many boxes as elements; more, and the boxes are full of what is not near.
constexpr int RUN = 16;

/// How far copies may have moved, in elements, before boxes are made anew.
constexpr double DRIFT = 0.5;

/// The largest way of any copy from where it was along an axis [m].
double farthest(const std::vector<Vec3>& x, const std::vector<Vec3>& was) {
  const auto flat = [&](const std::vector<Vec3>& points) {
    return Eigen::Map<const Eigen::ArrayXd>(points[0].data(), static_cast<Eigen::Index>(3 * was.size()));
  };
  return was.empty() ? 0 : (flat(x) - flat(was)).abs().maxCoeff();
}

}  // namespace

const std::vector<int>& NearParts::find(const Eigen::AlignedBox3d& reach, double room, const std::vector<Vec3>& x) {
  return within(reach, room, follow(x));
}

const std::vector<int>& NearParts::find(const Eigen::AlignedBox3d& reach, double room, const std::vector<Vec3>& x,
                                        const std::vector<Vec3>& before) {
  const double moved = follow(x);
  return within(reach, room, std::max(moved, farthest(before, was_)));
}

/// How far copies are at most from where they were when the boxes were made, which is now where that is too far.
double NearParts::follow(const std::vector<Vec3>& x) {
  if (was_.empty()) measure(x);
  for (int c = static_cast<int>(was_.size()); c < mesh_.numCopies(); ++c) was_.push_back(was_[mesh_.copyParent(c)]);
  const double moved = farthest(x, was_);
  if (moved <= DRIFT * size_) return moved;
  measure(x);
  return 0;
}

void NearParts::measure(const std::vector<Vec3>& x) {
  was_ = x;
  const int elements = static_cast<int>(mesh_.mesh().elements.size());
  runs_.assign((elements + RUN - 1) / RUN, Run());
  for (int e = 0; e < elements; ++e)
    for (int p = e; p >= 0; p = mesh_.parts()[p].next) {
      const Eigen::AlignedBox3d box = boxOf(mesh_.parts()[p], x);
      Run& run = runs_[e / RUN];
      run.box.extend(box);
      run.largest = run.largest.cwiseMax(box.sizes());
    }
}

const std::vector<int>& NearParts::within(const Eigen::AlignedBox3d& reach, double room, double moved) {
  found_.clear();
  const int elements = static_cast<int>(mesh_.mesh().elements.size());
  for (std::size_t r = 0; r < runs_.size(); ++r) {
    const Vec3 more = Vec3::Constant(moved) + room * (runs_[r].largest + Vec3::Constant(2 * moved));
    if (!reach.intersects(Eigen::AlignedBox3d(runs_[r].box.min() - more, runs_[r].box.max() + more))) continue;
    const int first = static_cast<int>(r) * RUN;
    for (int e = first; e < std::min(first + RUN, elements); ++e)
      for (int p = e; p >= 0; p = mesh_.parts()[p].next) found_.push_back(p);
  }
  std::sort(found_.begin(), found_.end());
  return found_;
}

}  // namespace incision
