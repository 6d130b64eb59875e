#pragma once

#include <numeric>
#include <vector>

namespace incision {

/// Values that lie one after the other in memory, somewhere else: valid as long as what holds them does not change.
template <typename T>
class Span {
 public:
  Span(T* begin, T* end) : begin_(begin), end_(end) {}
  T* begin() const { return begin_; }
  T* end() const { return end_; }
  int size() const { return static_cast<int>(end_ - begin_); }
  T& operator[](int i) const { return begin_[i]; }

 private:
  T *begin_, *end_;
};

/// Lists of values, all in one vector, one list after the other: list i is values()[start(i)] … values()[start(i + 1) −
/// 1]. They are made either one by one at the end, by `append` and `finish`, or all at once by `sort`. Making them anew
/// uses the memory that is there.
template <typename T>
class Lists {
 public:
  /// How many lists are finished.
  int count() const { return static_cast<int>(start_.size()) - 1; }
  /// Where a list starts among all values; start(count()) is where the last one ends.
  int start(int list) const { return start_[list]; }
  const std::vector<T>& values() const { return values_; }

  Span<const T> operator[](int list) const {
    return {values_.data() + start_[list], values_.data() + start_[list + 1]};
  }
  Span<T> operator[](int list) { return {values_.data() + start_[list], values_.data() + start_[list + 1]}; }

  /// Leaves no list.
  void clear() {
    start_.assign(1, 0);
    values_.clear();
  }

  /// Appends a value to the list that comes after the finished ones.
  void append(const T& value) { values_.push_back(value); }
  /// What has been appended since the last list was finished.
  Span<T> unfinished() { return {values_.data() + start_.back(), values_.data() + values_.size()}; }
  /// Makes a list, maybe an empty one, of what has been appended since the last.
  void finish() { start_.push_back(static_cast<int>(values_.size())); }

  /// Makes `count` lists in place of those there were, by a counting sort in linear time. forEach(f) has to call
  /// f(list, value) for every value, and is called twice: both times it must give the same lists. Values of one list
  /// keep the order in which they come.
  template <typename ForEach>
  void sort(int count, const ForEach& forEach) {
    // The values of list i are counted at i + 2. The sums then say at i + 1 where list i starts, and filling it moves
    // that on to where it ends.
    start_.assign(static_cast<std::size_t>(count) + 2, 0);
    forEach([this](int list, const T&) { ++start_[list + 2]; });
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    values_.resize(start_.back());
    forEach([this](int list, const T& value) { values_[start_[list + 1]++] = value; });
    start_.pop_back();
  }

 private:
  std::vector<int> start_ = {0};
  std::vector<T> values_;
};

/// The numbers i = 0, 1, … sorted into `count` lists by list_of[i], ascending in each.
inline Lists<int> sortedByList(const std::vector<int>& list_of, int count) {
  Lists<int> lists;
  lists.sort(count, [&](const auto& f) {
    for (std::size_t i = 0; i < list_of.size(); ++i) f(list_of[i], static_cast<int>(i));
  });
  return lists;
}

}  // namespace incision
