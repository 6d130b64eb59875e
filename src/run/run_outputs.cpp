#include "run_outputs.h"

#include <ostream>

#include "incision/base/printable.h"
#include "incision/base/why.h"
#include "incision/run/output_file.h"
#include "incision/run/snapshot.h"

namespace incision {

RunOutputs::RunOutputs(const BatchOptions& options, const DeformableBody& body) : options_(options) {
  if (!options.record.empty()) record_.emplace(options.record, body, !options.bag.empty());
  if (!options.positions.empty()) positions_ = openOutput(options.positions);
  if (!options.snapshot.empty()) snapshot_ = openOutput(options.snapshot);
  if (!options.volume.empty()) volume_ = openOutput(options.volume);
  if (!options.series.empty()) series_.emplace(options.series, options.every);
  if (!options.save.empty()) state_.emplace(options.save);
}

void RunOutputs::start(const DeformableBody& body) {
  if (series_) series_->add(body);
}

void RunOutputs::add(const DeformableBody& body, const StepResult& step) {
  if (record_) record_->write(body, step);
  if (series_) series_->add(body);
  if (record_) check(options_.record, record_->good());
  if (series_) check(options_.series, series_->good());
}

bool RunOutputs::check(const std::string& path, bool written) {
  if (!written && lost_.insert(path).second) remarks_.push_back(printable(path) + ": could not be written to the end");
  return written;
}

bool RunOutputs::finish(const DeformableBody& body, const std::string& leads, const SceneKey& key, const char* program,
                        std::ostream& err) {
  const bool saved = save(body, leads, key, program, err);
  bool written = !record_ || check(options_.record, record_->good());
  if (positions_) {
    writePositions(*positions_, body);
    written = check(options_.positions, static_cast<bool>(positions_->flush())) && written;
  }
  if (snapshot_) {
    writeSnapshot(*snapshot_, body);
    written = check(options_.snapshot, static_cast<bool>(snapshot_->flush())) && written;
  }
  if (volume_) {
    writeVolumeSnapshot(*volume_, body);
    written = check(options_.volume, static_cast<bool>(volume_->flush())) && written;
  }
  if (series_) {
    series_->add(body, true);
    written = check(options_.series, series_->good()) && written;
  }
  for (const std::string& remark : takeRemarks()) err << program << ": " << remark << std::endl;
  return saved && written;
}

bool RunOutputs::save(const DeformableBody& body, const std::string& leads, const SceneKey& key, const char* program,
                      std::ostream& err) {
  if (!state_) return true;
  try {
    SavedState state = savedState(body);
    state.leads = leads;
    state_->save(packed(state, key, body.scene().solver.threads));
    return true;
  } catch (const std::exception& error) {  // of the disk, or of memory
    err << program << ": " << printable(options_.save) << ": could not be written: " << whyOf(error) << std::endl;
    return false;
  }
}

}  // namespace incision
