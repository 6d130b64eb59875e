#pragma once

#include <cstdint>

#include "incision/surface/surface.h"

namespace incision {

/// The closed surface of a mesh that changes, built anew when it is asked for after a change. Not thread-safe.
class CurrentSurface {
 public:
  /// `mesh` must outlive this.
  explicit CurrentSurface(const CutMesh& mesh) : mesh_(mesh) {}

  /// The mesh has changed.
  void changed() { ++version_; }

  /// Grows whenever the mesh changes.
  std::uint64_t version() const { return version_; }

  const Surface& get() const {
    if (built_version_ != version_) surface_ = buildSurface(mesh_);
    built_version_ = version_;
    return surface_;
  }

 private:
  const CutMesh& mesh_;
  std::uint64_t version_ = 1;
  mutable Surface surface_;
  mutable std::uint64_t built_version_ = 0;
};

}  // namespace incision
