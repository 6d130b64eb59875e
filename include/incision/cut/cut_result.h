#pragma once

#include <cstdint>
#include <string>

namespace incision {

enum class CutStatus : std::uint8_t { APPLIED = 0, MISSED = 1, REJECTED = 2 };

/// What became of one cut.
struct CutResult {
  std::string label;
  CutStatus status = CutStatus::MISSED;
  std::string reason;  ///< why it was missed or rejected
  int cracks = 0;      ///< cracks it made: 0 or 1, more only by a stroke that crosses itself or turns a corner
  int parts_split = 0, copies_added = 0;
  int pieces = 0;       ///< of the body now
  double duration = 0;  ///< of the computation [s]
};

template <class Archive>
void serialize(Archive& archive, CutResult& result) {
  auto& [label, status, reason, cracks, parts_split, copies_added, pieces, duration] = result;
  archive(label, status, reason, cracks, parts_split, copies_added, pieces, duration);
}

}  // namespace incision
