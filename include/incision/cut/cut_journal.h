#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "incision/cut/cut_part.h"

namespace incision {

/// What changes of a cut mesh have replaced since its mark: with that they are undone, without memory from the heap.
/// What they have added needs no entry, only the sizes at the mark.
class CutJournal {
 public:
  /// Starts anew with a mesh of so many parts and details.
  void restart(std::size_t parts, std::size_t details) noexcept {
    parts_at_mark_ = parts;
    details_at_mark_ = details;
    parts_.clear();
    details_.clear();
  }

  /// To be called before a part changes.
  void keepPart(const std::vector<Part>& parts, int part) {
    if (static_cast<std::size_t>(part) < parts_at_mark_) parts_.emplace_back(part, parts[part]);
  }

  /// Before sides are added to a detail.
  void keepSides(const std::vector<CutPart>& details, int detail) {
    if (static_cast<std::size_t>(detail) < details_at_mark_)
      details_.push_back({detail, details[detail].face_sides.size(), std::nullopt});
  }

  /// Puts a detail in the place of one that there is.
  void replace(std::vector<CutPart>* details, int detail, CutPart&& by) {
    if (static_cast<std::size_t>(detail) < details_at_mark_) {
      details_.push_back({detail, 0, std::nullopt});
      details_.back().whole = std::move((*details)[detail]);
    }
    (*details)[detail] = std::move(by);
  }

  /// Puts all back as it was at the mark.
  void undo(std::vector<Part>* parts, std::vector<CutPart>* details) noexcept {
    parts->erase(parts->begin() + static_cast<std::ptrdiff_t>(parts_at_mark_), parts->end());
    details->erase(details->begin() + static_cast<std::ptrdiff_t>(details_at_mark_), details->end());
    for (auto entry = parts_.rbegin(); entry != parts_.rend(); ++entry) (*parts)[entry->first] = entry->second;
    for (auto entry = details_.rbegin(); entry != details_.rend(); ++entry) {
      CutPart& detail = (*details)[entry->detail];
      if (entry->whole)
        detail = std::move(*entry->whole);
      else
        detail.face_sides.erase(detail.face_sides.begin() + static_cast<std::ptrdiff_t>(entry->sides),
                                detail.face_sides.end());
    }
    parts_.clear();
    details_.clear();
  }

 private:
  struct OldDetail {
    int detail;
    std::size_t sides;             // how many there were
    std::optional<CutPart> whole;  // where it was replaced
  };

  std::size_t parts_at_mark_ = 0, details_at_mark_ = 0;
  std::vector<std::pair<int, Part>> parts_;
  std::vector<OldDetail> details_;
};

}  // namespace incision
