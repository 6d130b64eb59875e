#include "incision/run/batch.h"

#include <unistd.h>

#include <chrono>
#include <csignal>
#include <iomanip>
#include <iostream>
#include <optional>
#include <utility>

#include "incision/base/input_error.h"
#include "incision/base/printable.h"
#include "incision/body/deformable_body.h"
#include "incision/body/quantities.h"
#include "incision/body/remarks.h"
#include "incision/run/output_file.h"
#include "incision/run/run_record.h"
#include "incision/run/run_summary.h"
#include "incision/run/snapshot.h"
#include "incision/run/snapshot_series.h"
#include "incision/run/state_file.h"
#include "incision/scene/scene.h"

namespace incision {

namespace {

volatile std::sig_atomic_t stop_asked = 0;

constexpr const char* HELP =
    R"(usage: incision_batch SCENE.yaml [options]

Runs a scene and ends with one line of JSON on standard output.

  --steps N          steps to take (default 100; 0 only loads the scene)
  --set KEY=VALUE    replaces or adds one value of the scene, such as
                     solver.time_step=0.005 or cuts.0.normal=[1,0,0]; may be given often
  --threads N        short for --set solver.threads=N
  --record RUN.csv   one row a step: counts, momentum, energies, solver
  --positions END.txt
                     `x y z` of every mesh node at the end, in mesh order
  --snapshot END.vtu the surface and its stress at the end, for ParaView
  --volume END.vtu   the parts, likewise, with their displacements and regions
  --series RUN.pvd   both at the start, after every so many steps, and at the end
  --every N          how many steps for --series (default 10)
  --save END.state   all that outlasts the last step, to go on from
  --restore START.state
                     goes on where --save has left off with the same scene;
                     --steps counts from there
  --help             this text

Ctrl-C ends the run after the current step, outputs included.
Exit status: 0 done, 1 a step failed or an output could not be written, 2 bad input.
)";

// One line on a terminal that says how far the run is; nothing elsewhere.
class Progress {
 public:
  Progress(std::ostream& out, std::int64_t steps)
      : out_(out), steps_(steps), shown_(&out == &std::cerr && isatty(STDERR_FILENO)) {}
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(const DeformableBody& body, double step_ms) {
    const auto now = std::chrono::steady_clock::now();
    if (!shown_ || now < next_) return;
    next_ = now + std::chrono::milliseconds(100);
    out_ << "\rstep " << body.steps() << " of " << steps_ << ", " << body.time() << " s, " << step_ms << " ms a step  "
         << std::flush;
  }
  void clear() {
    if (shown_) out_ << "\r\033[K" << std::flush;
  }

 private:
  std::ostream& out_;
  std::int64_t steps_;
  bool shown_;
  std::chrono::steady_clock::time_point next_;
};

struct Outputs {
  std::optional<RunRecord> record;
  std::optional<SnapshotSeries> series;
  std::optional<std::ofstream> positions, snapshot, volume;
  std::optional<StateFile> state;
};

// Opened before the run, so that hours of it are not lost to a misspelt folder.
Outputs openOutputs(const BatchOptions& options, const DeformableBody& body) {
  Outputs outputs;
  if (!options.record.empty()) outputs.record.emplace(options.record, body);
  if (!options.positions.empty()) outputs.positions = openOutput(options.positions);
  if (!options.snapshot.empty()) outputs.snapshot = openOutput(options.snapshot);
  if (!options.volume.empty()) outputs.volume = openOutput(options.volume);
  if (!options.series.empty()) outputs.series.emplace(options.series, options.every);
  if (!options.save.empty()) outputs.state.emplace(options.save);
  return outputs;
}

void reportCuts(const std::vector<CutResult>& cuts, double time, std::ostream& err) {
  for (const CutResult& cut : cuts) {
    if (cut.status == CutStatus::APPLIED) continue;
    err << "incision_batch: cut '" << printable(cut.label) << "' at " << time << " s "
        << (cut.status == CutStatus::MISSED ? "missed: " : "was rejected: ") << cut.reason << std::endl;
  }
}

// Whether all steps could be taken.
bool takeSteps(const BatchOptions& options, DeformableBody& body, Outputs& outputs, StepStatistics& statistics,
               std::ostream& err) {
  const std::int64_t last = body.steps() + options.steps;
  Progress progress(err, last);
  if (outputs.series) outputs.series->add(body);
  try {
    while (body.steps() < last && !stop_asked) {
      const double time = body.time();
      const StepResult step = body.step();
      statistics.add(step);
      if (!step.cuts.empty()) progress.clear();
      reportCuts(step.cuts, time, err);
      if (outputs.record) outputs.record->write(body, step);
      if (outputs.series) outputs.series->add(body);
      progress.show(body, step.step_ms);
    }
  } catch (const StepFailed& failure) {
    progress.clear();
    reportCuts(body.takeReports().cuts, body.time(), err);
    err << "incision_batch: step " << body.steps() + 1 << " failed: " << failure.what() << std::endl;
    return false;
  }
  return true;
}

// Whether the body reached its file.
bool saveState(const BatchOptions& options, const DeformableBody& body, const SceneKey& key, Outputs& outputs,
               std::ostream& err) {
  if (!outputs.state) return true;
  try {
    outputs.state->save(packed(savedState(body), key, body.scene().solver.threads));
    return true;
  } catch (const std::exception& error) {  // of the disk, or of memory
    err << "incision_batch: " << printable(options.save) << ": could not be written: " << error.what() << std::endl;
    return false;
  }
}

// Whether everything reached its file.
bool writeOutputs(const BatchOptions& options, const DeformableBody& body, Outputs& outputs, std::ostream& err) {
  bool all_written = true;
  const auto check = [&](const std::string& path, bool written) {
    if (!written) err << "incision_batch: " << printable(path) << ": could not be written to the end" << std::endl;
    all_written = all_written && written;
  };
  if (outputs.record) check(options.record, outputs.record->good());
  if (outputs.positions) {
    writePositions(*outputs.positions, body);
    check(options.positions, static_cast<bool>(outputs.positions->flush()));
  }
  if (outputs.snapshot) {
    writeSnapshot(*outputs.snapshot, body);
    check(options.snapshot, static_cast<bool>(outputs.snapshot->flush()));
  }
  if (outputs.volume) {
    writeVolumeSnapshot(*outputs.volume, body);
    check(options.volume, static_cast<bool>(outputs.volume->flush()));
  }
  if (outputs.series) {
    outputs.series->add(body, true);
    check(options.series, outputs.series->good());
  }
  return all_written;
}

BatchStatus run(const BatchOptions& options, std::ostream& out, std::ostream& err) {
  const Scene scene = loadScene(options.scene, options.overrides);
  std::vector<std::string> notes;
  TetMesh mesh = loadMesh(scene, &notes);
  const Descriptions descriptions = loadDescriptions(scene);
  DeformableBody body(scene, std::move(mesh), descriptions);
  const bool keyed = !options.restore.empty() || !options.save.empty();
  const SceneKey key = keyed ? keyOf(body, descriptions) : SceneKey();
  if (!options.restore.empty()) restoreState(options.restore, key, &body);
  for (const std::string& remark : remarksOn(body.scene(), body.mesh())) notes.push_back("warning: " + remark);
  for (const std::string& remark : remarksOnShapes(body)) notes.push_back("warning: " + remark);
  body.wantWrenches(!options.record.empty());
  Outputs outputs = openOutputs(options, body);
  notes.push_back(describe(body));
  for (const std::string& note : notes) err << "incision_batch: " << note << std::endl;
  StepStatistics statistics;
  const bool stepped = takeSteps(options, body, outputs, statistics, err);
  const bool saved = saveState(options, body, key, outputs, err);
  const bool written = writeOutputs(options, body, outputs, err);
  out << summaryLine(body, statistics) << std::endl;
  return stepped && saved && written && out ? BatchStatus::DONE : BatchStatus::FAILED;
}

}  // namespace

BatchStatus runBatch(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err) {
  try {
    const BatchOptions options = parseBatchArguments(arguments);
    if (!options.help) return run(options, out, err);
    out << HELP;
    return BatchStatus::DONE;
  } catch (const InputError& error) {
    err << "incision_batch: " << error.what() << std::endl;
    return BatchStatus::BAD_INPUT;
  } catch (const std::bad_alloc&) {
    err << "incision_batch: not enough memory for this scene" << std::endl;
    return BatchStatus::FAILED;
  }
}

void stopBatch() { stop_asked = 1; }

}  // namespace incision
