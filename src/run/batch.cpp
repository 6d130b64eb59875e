#include "incision/run/batch.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <iostream>
#include <sstream>
#include <utility>

#include "incision/base/input_error.h"
#include "incision/base/printable.h"
#include "incision/body/deformable_body.h"
#include "incision/body/quantities.h"
#include "incision/body/remarks.h"
#include "incision/run/first_steps.h"
#include "incision/run/run_summary.h"
#include "incision/run/state_file.h"
#include "incision/scene/scene.h"
#include "run_outputs.h"

namespace incision {

namespace {

volatile std::sig_atomic_t stop_asked = 0;

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

// What a run consists of.
struct Run {
  const BatchProgram& program;
  const BatchOptions& options;
  DeformableBody& body;
  StepSource* source;  // none: the scene alone
  std::ostream& err;

  void say(const std::string& line) const { err << program.name << ": " << line << std::endl; }
};

// What there is to say before or after a step, with the progress out of its way.
void sayRemarks(const Run& run, const std::vector<CutResult>& cuts, double time, Progress* progress,
                std::vector<std::string> remarks = {}) {
  if (run.source != nullptr)
    for (std::string& remark : run.source->takeRemarks()) remarks.push_back(std::move(remark));
  for (const CutResult& cut : cuts)
    if (run.source == nullptr && cut.status != CutStatus::APPLIED) remarks.push_back(remarkOn(cut, time));
  if (!remarks.empty()) progress->clear();
  for (const std::string& remark : remarks) run.say(remark);
}

// Whether all steps could be taken.
bool takeSteps(const Run& run, RunOutputs& outputs, StepStatistics& statistics) {
  DeformableBody& body = run.body;
  const std::int64_t steps = run.source != nullptr ? run.source->steps() : run.options.steps;
  const std::int64_t last = body.steps() + run.options.steps;
  Progress progress(run.err, body.steps() + std::min(steps, run.options.steps));
  FirstSteps first_steps(body.scene().solver.time_step);
  outputs.start(body);
  try {
    while (body.steps() < last && !stop_asked && (run.source == nullptr || run.source->prepare())) {
      const double time = body.time();
      const StepResult step = body.step();
      statistics.add(step);
      if (run.source != nullptr) run.source->taken(step);
      outputs.add(body, step);
      std::vector<std::string> remarks = outputs.takeRemarks();
      if (auto pace = first_steps.add(step.step_ms)) remarks.push_back(std::move(*pace));
      sayRemarks(run, step.cuts, time, &progress, std::move(remarks));
      progress.show(body, step.step_ms);
    }
    if (run.source != nullptr) run.source->finish({});
    sayRemarks(run, {}, body.time(), &progress);
  } catch (const StepFailed& failure) {
    const std::vector<CutResult> cuts = body.takeReports().cuts;
    if (run.source != nullptr) run.source->finish(cuts);
    sayRemarks(run, cuts, body.time(), &progress);
    progress.clear();
    run.say("step " + std::to_string(body.steps() + 1) + " failed: " + failure.what());
    return false;
  }
  return true;
}

BatchStatus runScene(const BatchProgram& program, const BatchOptions& options, std::ostream& out, std::ostream& err) {
  const Scene scene = program.load(options);
  std::vector<std::string> notes;
  TetMesh mesh = loadMesh(scene, &notes);
  const Descriptions descriptions = loadDescriptions(scene);
  DeformableBody body(scene, std::move(mesh), descriptions);
  const bool keyed = !options.restore.empty() || !options.save.empty();
  const SceneKey key = keyed ? keyOf(body, descriptions) : SceneKey();
  std::string leads;
  if (!options.restore.empty()) leads = restoreState(options.restore, key, &body);
  for (const std::string& remark : remarksOn(body.scene(), body.mesh())) notes.push_back("warning: " + remark);
  for (const std::string& remark : remarksOnShapes(body)) notes.push_back("warning: " + remark);
  body.wantWrenches(!options.record.empty());
  const std::unique_ptr<StepSource> source = program.open ? program.open(options, &body) : nullptr;
  if (source && !options.restore.empty()) source->recall(leads);
  RunOutputs outputs(options, body);
  notes.push_back(describe(body));
  const Run run = {program, options, body, source.get(), err};
  for (const std::string& note : notes) run.say(note);
  StepStatistics statistics;
  const bool stepped = takeSteps(run, outputs, statistics);
  const bool written = outputs.finish(body, source ? source->leads() : "", key, program.name, err);
  out << summaryLine(body, statistics, source.get()) << std::endl;
  return stepped && written && out ? BatchStatus::DONE : BatchStatus::FAILED;
}

}  // namespace

std::string remarkOn(const CutResult& cut, double time) {
  std::ostringstream remark;
  remark << "cut '" << printable(cut.label) << "' at " << time << " s "
         << (cut.status == CutStatus::MISSED ? "missed: " : "was rejected: ") << cut.reason;
  return remark.str();
}

BatchStatus runProgram(const BatchProgram& program, const std::vector<std::string>& arguments, std::ostream& out,
                       std::ostream& err) {
  try {
    const BatchOptions options = parseArguments(program, arguments);
    if (!options.help) return runScene(program, options, out, err);
    out << helpOf(program);
    return BatchStatus::DONE;
  } catch (const InputError& error) {
    err << program.name << ": " << error.what() << std::endl;
    return BatchStatus::BAD_INPUT;
  } catch (const std::bad_alloc&) {
    err << program.name << ": not enough memory for this scene" << std::endl;
    return BatchStatus::FAILED;
  }
}

BatchStatus runBatch(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err) {
  return runProgram(BATCH, arguments, out, err);
}

void stopAtSignals() {
  const auto stop = [](int signal) {
    stop_asked = 1;
    std::signal(signal, SIG_DFL);
  };
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
}

}  // namespace incision
