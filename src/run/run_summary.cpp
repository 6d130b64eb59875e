#include "incision/run/run_summary.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "incision/body/quantities.h"
#include "incision/run/version.h"
#include "incision/tool/tool.h"

namespace incision {

namespace {

using Json = nlohmann::ordered_json;

Json toJson(std::int64_t number) { return number; }
Json toJson(double number) { return number; }
Json toJson(const Vec3& vector) { return Json::array({vector.x(), vector.y(), vector.z()}); }

double peakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;  // Linux counts in KiB
}

void add(const std::vector<Quantity>& quantities, Json* group) {
  for (const Quantity& quantity : quantities)
    (*group)[quantity.name] = std::visit([](const auto& value) { return toJson(value); }, quantity.value);
}

/// By nearest rank; 0 where there are none.
template <typename T>
T quantileOf(std::vector<T> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  return values[std::max<std::size_t>(rank, 1) - 1];
}

const char* wordFor(CutStatus status) {
  return status == CutStatus::APPLIED ? "applied" : status == CutStatus::MISSED ? "missed" : "rejected";
}

Json told(const std::string& label, const char* status, const std::string& reason) {
  return {{"label", label}, {"status", status}, {"reason", reason}};
}

/// The cuts that took effect, then those of the scene that have not come due.
Json cutsOf(const DeformableBody& body, const RunAccount& account) {
  Json cuts = Json::array();
  for (const CutResult& cut : account.cuts) cuts.push_back(told(cut.label, wordFor(cut.status), cut.reason));
  // A step that failed has begun.
  const double time_step = body.scene().solver.time_step;
  const std::int64_t begun = account.failure.empty() ? body.steps() - 1 : body.steps();
  for (const ScheduledCut& cut : body.scene().cuts)
    if (begun < 0 || cut.time > static_cast<double>(begun) * time_step + DUE_TOLERANCE)
      cuts.push_back(told(cut.plane.label, "pending", "the run ended before its time"));
  return cuts;
}

}  // namespace

void StepStatistics::add(const StepResult& step) {
  step_ms_.push_back(step.step_ms);
  sum_ += step.phase_ms;
  last_.contact = step.contact;
  last_.iterations = step.iterations;
  last_.residual = step.residual;
  last_.solves = step.solves;
  last_.settled = step.settled;
  last_.tools = step.tools;
  solves_.push_back(step.solves);
}

double StepStatistics::quantile(double share) const { return quantileOf(step_ms_, share); }

int StepStatistics::solvesQuantile(double share) const { return quantileOf(solves_, share); }

PhaseTimes StepStatistics::meanPhases() const {
  const double n = std::max<double>(1, static_cast<double>(step_ms_.size()));
  return {sum_.cut / n, sum_.fracture / n, sum_.contact / n, sum_.assembly / n, sum_.solve / n, sum_.update / n};
}

std::string summaryLine(const DeformableBody& body, const StepStatistics& statistics, const RunAccount& account,
                        const StepSource* source) {
  const PhaseTimes phases = statistics.meanPhases();
  Json line;
  line["scene"] = account.scene;
  line["set"] = account.overrides;
  line["version"] = version();
  line["interrupted"] = account.interrupted;
  line["failure"] = account.failure.empty() ? Json() : Json(account.failure);
  line["cuts"] = cutsOf(body, account);
  line["steps"] = body.steps();
  line["time"] = body.time();
  add(quantitiesOf(body, statistics.last()), &line);
  line["bounds"] = {toJson(body.bounds().min), toJson(body.bounds().max)};
  line["piece_volumes"] = body.pieceVolumes();
  const std::vector<double> volumes = body.regionVolumes();
  const Regions& regions = body.materials().regions();
  for (int r = 0; r < regions.count(); ++r) line["regions"][regions.name(r)] = volumes[r];
  line["step_ms"] = {
      {"median", statistics.quantile(0.5)}, {"p99", statistics.quantile(0.99)}, {"max", statistics.quantile(1)}};
  line["phase_ms"] = {{"cut", phases.cut},           {"fracture", phases.fracture}, {"contact", phases.contact},
                      {"assembly", phases.assembly}, {"solve", phases.solve},       {"update", phases.update}};
  line["contacts"] = {{"count", statistics.last().contact.count},
                      {"deepest", statistics.last().contact.deepest},
                      {"energy", statistics.last().contact.energy},
                      {"solves", {{"median", statistics.solvesQuantile(0.5)}, {"max", statistics.solvesQuantile(1)}}},
                      {"unsettled", body.unsettledSteps()}};
  for (std::size_t i = 0; i < body.tools(); ++i)
    add(toolQuantitiesOf(body, i, statistics.last()), &line["tools"][body.scene().tools[i].name]);
  if (source != nullptr) add(source->quantities(), &line[source->name()]);
  line["peak_rss_mb"] = peakMemory();
  line["state_hash"] = hexadecimal(body.stateHash());
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace incision
