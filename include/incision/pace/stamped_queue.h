#pragma once

#include <algorithm>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

#include "incision/pace/command.h"

namespace incision {

/// Things ordered by stamp, and those of one stamp by arrival. A thing knows when it was `received`.
template <class T>
class StampedQueue {
 public:
  struct Entry {
    Nanoseconds stamp;
    std::int64_t arrival;  ///< counts up
    T thing;
  };

  void add(T thing, Nanoseconds stamp) {
    const auto place = std::upper_bound(entries_.begin(), entries_.end(), stamp,
                                        [](Nanoseconds time, const Entry& entry) { return time < entry.stamp; });
    entries_.insert(place, {stamp, arrivals_++, std::move(thing)});
  }

  /// What is stamped up to `time`.
  std::vector<T> take(Nanoseconds time) {
    std::vector<T> taken;
    for (; !entries_.empty() && entries_.front().stamp <= time; entries_.pop_front())
      taken.push_back(std::move(entries_.front().thing));
    return taken;
  }

  std::vector<T> takeAll() {
    std::vector<T> taken;
    for (Entry& entry : std::exchange(entries_, {})) taken.push_back(std::move(entry.thing));
    return taken;
  }

  /// The last one; there must be one.
  T takeLast() {
    T last = std::move(entries_.back().thing);
    entries_.pop_back();
    return last;
  }

  /// Leaves out the thing, of three or more, that is missed least: the one with the closest neighbours, by arrival.
  /// Both ends stay.
  void thin() {
    std::size_t closest = 1;
    const auto gap = [this](std::size_t i) { return entries_[i + 1].arrival - entries_[i - 1].arrival; };
    for (std::size_t i = 2; i + 1 < entries_.size(); ++i)
      if (gap(i) < gap(closest)) closest = i;
    entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(closest));
  }

  std::size_t size() const { return entries_.size(); }

  /// Of what is stamped later than `time` the thing that was received first; null where there is none.
  const Entry* firstAfter(Nanoseconds time) const {
    const Entry* first = nullptr;
    for (const Entry& entry : entries_)
      if (entry.stamp > time && (first == nullptr || entry.thing.received < first->thing.received)) first = &entry;
    return first;
  }

 private:
  std::deque<Entry> entries_;
  std::int64_t arrivals_ = 0;
};

}  // namespace incision
