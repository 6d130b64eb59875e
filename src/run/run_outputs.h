#pragma once

#include <fstream>
#include <iosfwd>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "incision/run/batch.h"
#include "incision/run/run_record.h"
#include "incision/run/scene_key.h"
#include "incision/run/snapshot_series.h"
#include "incision/run/state_file.h"

namespace incision {

/// The files that a run writes. All are opened before the run, so that hours of it are not lost to a misspelt folder.
class RunOutputs {
 public:
  /// Throws InputError when one cannot be created.
  RunOutputs(const BatchOptions& options, const DeformableBody& body);

  /// Before the first step, and after each.
  void start(const DeformableBody& body);
  void add(const DeformableBody& body, const StepResult& step);

  /// Of files that are lost, once of each: a run of hours does not wait for its end to say so.
  std::vector<std::string> takeRemarks() { return std::exchange(remarks_, {}); }

  /// After the last step. Whether everything reached its file; of what did not there is a line on `err`, which begins
  /// with `program`. `leads`: of the saved body.
  bool finish(const DeformableBody& body, const std::string& leads, const SceneKey& key, const char* program,
              std::ostream& err);

 private:
  bool check(const std::string& path, bool written);
  bool save(const DeformableBody& body, const std::string& leads, const SceneKey& key, const char* program,
            std::ostream& err);

  const BatchOptions options_;
  std::optional<RunRecord> record_;
  std::optional<SnapshotSeries> series_;
  std::optional<std::ofstream> positions_, snapshot_, volume_;
  std::optional<StateFile> state_;
  std::set<std::string> lost_;
  std::vector<std::string> remarks_;
};

}  // namespace incision
