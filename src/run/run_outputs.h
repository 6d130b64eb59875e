#pragma once

#include <fstream>
#include <iosfwd>
#include <optional>
#include <string>

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

  /// After the last step. Whether everything reached its file; of what did not there is a line on `err`, which begins
  /// with `program`. `leads`: of the saved body.
  bool finish(const DeformableBody& body, const std::string& leads, const SceneKey& key, const char* program,
              std::ostream& err);

 private:
  bool save(const DeformableBody& body, const std::string& leads, const SceneKey& key, const char* program,
            std::ostream& err);

  const BatchOptions options_;
  std::optional<RunRecord> record_;
  std::optional<SnapshotSeries> series_;
  std::optional<std::ofstream> positions_, snapshot_, volume_;
  std::optional<StateFile> state_;
};

}  // namespace incision
