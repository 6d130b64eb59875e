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
    const auto isDue = [time](const Entry& entry) { return entry.stamp <= time; };
    return takeFirst(std::find_if_not(entries_.begin(), entries_.end(), isDue) - entries_.begin());
  }

  /// The first one; there must be one.
  T takeNext() noexcept {
    T next = std::move(entries_.front().thing);
    entries_.pop_front();
    return next;
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

  void clear() noexcept { entries_.clear(); }

  std::size_t size() const { return entries_.size(); }

  /// Of what is stamped later than `time` the thing that was received first; null where there is none.
  const Entry* firstAfter(Nanoseconds time) const {
    const Entry* first = nullptr;
    for (const Entry& entry : entries_)
      if (entry.stamp > time && (first == nullptr || entry.thing.received < first->thing.received)) first = &entry;
    return first;
  }

 private:
  /// None is lost where there is no memory to take them.
  std::vector<T> takeFirst(std::ptrdiff_t count) {
    std::vector<T> taken;
    taken.reserve(static_cast<std::size_t>(count));
    for (auto entry = entries_.begin(); entry != entries_.begin() + count; ++entry)
      taken.push_back(std::move(entry->thing));
    entries_.erase(entries_.begin(), entries_.begin() + count);
    return taken;
  }

  std::deque<Entry> entries_;
  std::int64_t arrivals_ = 0;
};

}  // namespace incision
