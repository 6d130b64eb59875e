#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cereal/archives/portable_binary.hpp>
#include <cereal/types/array.hpp>
#include <cereal/types/common.hpp>
#include <cereal/types/deque.hpp>
#include <cereal/types/map.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/set.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/utility.hpp>
#include <cereal/types/vector.hpp>
#include <cmath>
#include <cstring>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <vector>

#include "incision/base/memory_limits.h"

/// Bytes that values are written to and read from. What belongs to a struct is said beside it by
///
///   template <class Archive>
///   void serialize(Archive& archive, Pair& pair) {
///     auto& [a, b] = pair;
///     archive(a, b);
///   }
///
/// which no longer compiles when the struct gets a field that it leaves out. Headers need nothing of this one for that.
namespace incision {

using ArchiveWriter = cereal::PortableBinaryOutputArchive;

/// Reads what an ArchiveWriter has written, and takes nothing on trust: it makes no room for more than the bytes can
/// hold, and refuses numbers that are not finite. Throws InputError.
class ArchiveReader : public cereal::InputArchive<ArchiveReader, cereal::AllowEmptyClassElision> {
 public:
  /// The bytes must outlive this.
  explicit ArchiveReader(std::string_view bytes);

  /// What is read next is checked against these.
  MemoryLimits limits;

  /// How many bytes are still to be read.
  std::size_t left() const { return left_.size(); }

  /// Copies the next bytes.
  void take(void* to, std::size_t count) {
    if (count > left_.size()) failAtEnd();
    if (count == 0) return;
    std::memcpy(to, left_.data(), count);
    left_.remove_prefix(count);
  }

  /// Copies the next numbers.
  template <typename T>
  void takeNumbers(T* to, std::size_t count) {
    take(to, count * sizeof(T));
    if constexpr (std::is_floating_point_v<T>)
      for (std::size_t i = 0; i < count; ++i)
        if (!std::isfinite(to[i])) failAtNumber();
  }

  /// The length of a list, each entry of which takes a byte at least.
  std::size_t takeLength() {
    cereal::size_type length = 0;
    takeNumbers(&length, 1);
    if (length > left_.size()) failAtEnd();
    return length;
  }

  [[noreturn]] static void failAtEnd();
  [[noreturn]] static void failAtNumber();

 private:
  std::string_view left_;
};

}  // namespace incision

/// Whose bytes it reads, which cereal asks for.
template <>
struct cereal::traits::detail::get_output_from_input<incision::ArchiveReader> {
  using type = incision::ArchiveWriter;
};

namespace incision {

template <typename T>
std::enable_if_t<std::is_arithmetic_v<T>> load(ArchiveReader& archive, T& number) {
  if constexpr (std::is_same_v<T, bool>) {
    std::uint8_t byte = 0;
    archive.takeNumbers(&byte, 1);
    if (byte > 1) ArchiveReader::failAtNumber();
    number = byte == 1;
  } else {
    archive.takeNumbers(&number, 1);
  }
}

template <typename T>
void load(ArchiveReader& archive, cereal::NameValuePair<T>& pair) {
  archive(pair.value);
}

template <typename T>
void load(ArchiveReader& archive, cereal::SizeTag<T>& tag) {
  tag.size = archive.takeLength();
}

template <typename T>
void load(ArchiveReader& archive, cereal::BinaryData<T>& data) {
  using Number = std::remove_pointer_t<T>;
  archive.takeNumbers(static_cast<Number*>(data.data), static_cast<std::size_t>(data.size) / sizeof(Number));
}

/// Grows with what is read, whatever length the bytes claim.
template <typename T, typename Allocator>
std::enable_if_t<!std::is_arithmetic_v<T>> load(ArchiveReader& archive, std::vector<T, Allocator>& list) {
  const std::size_t length = archive.takeLength();
  list.clear();
  list.reserve(std::min(length, archive.left() / sizeof(T) + 1));
  while (list.size() < length) archive(list.emplace_back());
}

template <typename T, typename Allocator>
std::enable_if_t<std::is_arithmetic_v<T> && !std::is_same_v<T, bool>> load(ArchiveReader& archive,
                                                                           std::vector<T, Allocator>& list) {
  const std::size_t length = archive.takeLength();
  if (length > archive.left() / sizeof(T)) ArchiveReader::failAtEnd();
  list.resize(length);
  archive.takeNumbers(list.data(), length);
}

}  // namespace incision

namespace Eigen {

/// Of a size that is known when it is compiled.
template <class Archive, typename Scalar, int Rows, int Columns, int Options>
void serialize(Archive& archive, Matrix<Scalar, Rows, Columns, Options>& matrix) {
  static_assert(Rows > 0 && Columns > 0);
  archive(cereal::binary_data(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(Scalar)));
}

template <class Archive, typename Scalar, int Options>
void serialize(Archive& archive, Quaternion<Scalar, Options>& quaternion) {
  archive(quaternion.coeffs());
}

}  // namespace Eigen

namespace cereal {

/// By ascending keys: so equal maps give equal bytes, however they came about.
template <class Archive, typename Key, typename Value, typename... Rest>
void save(Archive& archive, const std::unordered_map<Key, Value, Rest...>& map) {
  std::vector<const std::pair<const Key, Value>*> sorted;
  for (const auto& entry : map) sorted.push_back(&entry);
  std::sort(sorted.begin(), sorted.end(), [](const auto* a, const auto* b) { return a->first < b->first; });
  archive(make_size_tag(static_cast<size_type>(sorted.size())));
  for (const auto* entry : sorted) archive(entry->first, entry->second);
}

template <class Archive, typename Key, typename Value, typename... Rest>
void load(Archive& archive, std::unordered_map<Key, Value, Rest...>& map) {
  size_type size = 0;
  archive(make_size_tag(size));
  map.clear();
  for (; size > 0; --size) {
    Key key;
    archive(key);
    archive(map[key]);
  }
}

}  // namespace cereal
