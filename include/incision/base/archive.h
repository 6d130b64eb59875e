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
#include <unordered_map>
#include <vector>

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
using ArchiveReader = cereal::PortableBinaryInputArchive;

}  // namespace incision

namespace Eigen {

template <class Archive, typename Scalar, int Rows, int Columns, int Options, int MaxRows, int MaxColumns>
void save(Archive& archive, const Matrix<Scalar, Rows, Columns, Options, MaxRows, MaxColumns>& matrix) {
  if constexpr (Rows == Dynamic) archive(static_cast<std::int64_t>(matrix.rows()));
  if constexpr (Columns == Dynamic) archive(static_cast<std::int64_t>(matrix.cols()));
  archive(cereal::binary_data(matrix.data(), static_cast<std::size_t>(matrix.size()) * sizeof(Scalar)));
}

template <class Archive, typename Scalar, int Rows, int Columns, int Options, int MaxRows, int MaxColumns>
void load(Archive& archive, Matrix<Scalar, Rows, Columns, Options, MaxRows, MaxColumns>& matrix) {
  std::int64_t rows = Rows, columns = Columns;
  if constexpr (Rows == Dynamic) archive(rows);
  if constexpr (Columns == Dynamic) archive(columns);
  matrix.resize(rows, columns);
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
