#pragma once

#include <cstdint>
#include <fstream>
#include <string>

#include "incision/body/deformable_body.h"

namespace incision {

/// Snapshots of surface and volume every so many steps, as files beside a list of them that ParaView opens:
/// NAME.pvd, and NAME_surface_STEP.vtu and NAME_volume_STEP.vtu for each.
class SnapshotSeries {
 public:
  /// Throws InputError when the list cannot be created, or its name does not end in ".pvd". `every` ≥ 1.
  SnapshotSeries(const std::string& path, std::int64_t every);

  /// Writes the body as it is, where its step is due or `must` is set, unless this step is there already.
  void add(const DeformableBody& body, bool must = false);

  /// Whether everything has reached the files.
  bool good() const { return good_; }

 private:
  std::string stem_;  // of the path
  std::int64_t every_, last_ = -1;
  std::ofstream list_;
  bool good_ = true;
};

}  // namespace incision
