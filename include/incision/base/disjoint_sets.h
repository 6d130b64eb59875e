#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace incision {

/// The numbers 0 … n − 1 in sets that join: at first each is a set of its own. A set is known by its lowest number, so
/// what comes out does not depend on the order in which sets were joined. Every call takes almost constant time on the
/// mean.
class DisjointSets {
 public:
  explicit DisjointSets(int n = 0) { reset(n); }

  /// Starts afresh with n sets of one number each.
  void reset(int n) {
    link_.resize(n);
    std::iota(link_.begin(), link_.end(), 0);
  }

  /// The lowest number of the set that has this one.
  int lowest(int number) {
    while (link_[number] != number) number = link_[number] = link_[link_[number]];
    return number;
  }

  /// Makes one set of those of two numbers. Returns whether they were two.
  bool join(int a, int b) {
    if (link_[a] == link_[b]) return false;
    a = lowest(a);
    b = lowest(b);
    link_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

  /// Numbers the sets from 0, in the order of their lowest numbers, and writes to `set_of` the one that each number is
  /// in. Returns how many there are.
  int enumerate(std::vector<int>* set_of) {
    int count = 0;
    set_of->resize(link_.size());
    for (int i = 0; i < static_cast<int>(link_.size()); ++i)
      (*set_of)[i] = link_[i] == i ? count++ : (*set_of)[lowest(i)];
    return count;
  }

 private:
  std::vector<int> link_;  // from each number towards the lowest of its set, which links to itself
};

}  // namespace incision
