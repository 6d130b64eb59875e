#include "incision/run/batch.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <iostream>
#include <optional>
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
#include "incision/run/summary_file.h"
#include "incision/scene/scene.h"
#include "run_outputs.h"

namespace incision {

namespace {

volatile std::sig_atomic_t stop_signal = 0;  // 0: none has come

// How often a run says how far it is: on a terminal in one line that changes, elsewhere in a line each.
constexpr std::chrono::milliseconds SHOWN_EVERY(100), LOGGED_EVERY(10000);

// Says how far the run is.
class Progress {
 public:
  Progress(std::ostream& out, const char* program, std::int64_t steps)
      : out_(out),
        program_(program),
        steps_(steps),
        on_terminal_(&out == &std::cerr && isatty(STDERR_FILENO)),
        next_(std::chrono::steady_clock::now() + period()) {}
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(const DeformableBody& body, double step_ms) {
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + period();
    out_ << (on_terminal_ ? "\r" : program_ + ": ") << "step " << body.steps() << " of " << steps_ << ", "
         << body.time() << " s, " << step_ms << " ms a step" << (on_terminal_ ? "  " : "\n") << std::flush;
  }
  void clear() {
    if (on_terminal_) out_ << "\r\033[K" << std::flush;
  }

 private:
  std::chrono::milliseconds period() const { return on_terminal_ ? SHOWN_EVERY : LOGGED_EVERY; }

  std::ostream& out_;
  std::string program_;
  std::int64_t steps_;
  bool on_terminal_;
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

// Takes the steps, and returns what there is to tell of them.
RunAccount takeSteps(const Run& run, RunOutputs& outputs, StepStatistics& statistics) {
  DeformableBody& body = run.body;
  const std::int64_t steps = run.source != nullptr ? run.source->steps() : run.options.steps;
  const std::int64_t last = body.steps() + run.options.steps;
  RunAccount account = {run.options.scene, run.options.overrides, {}, false, ""};
  const auto keep = [&](const std::vector<CutResult>& cuts) {
    account.cuts.insert(account.cuts.end(), cuts.begin(), cuts.end());
  };
  Progress progress(run.err, run.program.name, body.steps() + std::min(steps, run.options.steps));
  FirstSteps first_steps(body.scene().solver.time_step);
  outputs.start(body);
  try {
    while (body.steps() < last) {
      account.interrupted = stop_signal != 0;
      if (account.interrupted || (run.source != nullptr && !run.source->prepare())) break;
      const double time = body.time();
      const StepResult step = body.step();
      statistics.add(step);
      if (run.source != nullptr) run.source->taken(step);
      outputs.add(body, step);
      keep(step.cuts);
      std::vector<std::string> remarks = outputs.takeRemarks();
      if (auto pace = first_steps.add(step.step_ms)) remarks.push_back(std::move(*pace));
      sayRemarks(run, step.cuts, time, &progress, std::move(remarks));
      progress.show(body, step.step_ms);
    }
    if (run.source != nullptr) run.source->finish({});
    sayRemarks(run, {}, body.time(), &progress);
  } catch (const StepFailed& failure) {
    const std::vector<CutResult> cuts = body.takeReports().cuts;
    keep(cuts);
    if (run.source != nullptr) run.source->finish(cuts);
    sayRemarks(run, cuts, body.time(), &progress);
    progress.clear();
    account.failure = "step " + std::to_string(body.steps() + 1) + " failed: " + failure.what();
    run.say(account.failure);
  }
  if (run.source != nullptr) account.cuts = run.source->cuts();
  return account;
}

BatchStatus statusOf(const RunAccount& account, const BatchOptions& options, bool written) {
  const auto went_wrong = [](const CutResult& cut) { return cut.status != CutStatus::APPLIED; };
  if (account.interrupted) return stop_signal == SIGTERM ? BatchStatus::TERMINATED : BatchStatus::INTERRUPTED;
  if (!written) return BatchStatus::FAILED;
  if (!account.failure.empty() && !options.keep_going) return BatchStatus::STEP_FAILED;
  if (options.strict && std::any_of(account.cuts.begin(), account.cuts.end(), went_wrong))
    return BatchStatus::CUT_MISSED;
  return BatchStatus::DONE;
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
  std::optional<SummaryFile> summary;
  if (!options.summary.empty()) summary.emplace(options.summary);
  notes.push_back(describe(body));
  const Run run = {program, options, body, source.get(), err};
  for (const std::string& note : notes) run.say(note);
  StepStatistics statistics;
  const RunAccount account = takeSteps(run, outputs, statistics);
  bool written = outputs.finish(body, source ? source->leads() : "", key, program.name, err);
  const std::string line = summaryLine(body, statistics, account, source.get());
  if (summary && !summary->keep(line)) {
    run.say(printable(options.summary) + ": could not be written");
    written = false;
  }
  out << line << std::endl;
  return statusOf(account, options, written && out);
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
    stop_signal = signal;
    std::signal(signal, SIG_DFL);
  };
  std::signal(SIGINT, stop);
  std::signal(SIGTERM, stop);
}

}  // namespace incision
