#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace incision {

/// A list that takes nothing from the heap as long as it has no more than N values.
template <class T, std::size_t N>
class ShortList {
 public:
  void push_back(const T& value) {
    if (size_ < N) {
      few_[size_] = value;
    } else {
      if (size_ == N) many_.assign(few_.begin(), few_.end());
      many_.push_back(value);
    }
    ++size_;
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  const T* begin() const { return size_ <= N ? few_.data() : many_.data(); }
  const T* end() const { return begin() + size_; }
  const T& operator[](std::size_t i) const { return begin()[i]; }

 private:
  std::size_t size_ = 0;
  std::array<T, N> few_{};
  std::vector<T> many_;  // all of them, where they are more than N
};

}  // namespace incision
