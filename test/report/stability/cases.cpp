#include "cases.h"

#include <cmath>
#include <cstdio>
#include <limits>

namespace incision::report {
namespace {

/// How much of its bound a figure takes; what is not a number takes all.
double shareOf(double figure, double bound) {
  if (std::isnan(figure)) return std::numeric_limits<double>::infinity();
  if (figure <= 0) return 0;
  return bound > 0 ? figure / bound : std::numeric_limits<double>::infinity();
}

}  // namespace

void Matrix::begin(const std::string& group) {
  group_ = group;
  worst_ = 0;
  count_ = 0;
}

void Matrix::add(const std::string& name, double figure, double bound, const std::string& reason) {
  list(name, figure, bound, reason, false);
  const double share = shareOf(figure, bound);
  if (count_++ > 0 && share <= worst_) return;
  worst_ = share;
  worst_name_ = name;
}

void Matrix::addLimit(const std::string& name, double figure, double bound, const std::string& reason) {
  list(name, figure, bound, reason, true);
}

void Matrix::list(const std::string& name, double figure, double bound, const std::string& reason, bool limit) {
  const bool passes = figure <= bound;
  std::printf("  %-5s %s: %s: %.3g, at most %.3g\n",
              passes  ? "pass"
              : limit ? "limit"
                      : "FAIL",
              group_.c_str(), name.c_str(), figure, bound);
  std::fflush(stdout);
  nlohmann::json row = {{"group", group_},  {"name", name},   {"bound", bound},
                        {"reason", reason}, {"limit", limit}, {"passes", passes}};
  row["figure"] = std::isfinite(figure) ? nlohmann::json(figure) : nlohmann::json();
  findings_->data()["cases"].push_back(row);
}

void Matrix::end() {
  if (count_ == 0) return;
  findings_->claimBelow(group_ + ": share of its bound that the worst of " + std::to_string(count_) + " cases takes (" +
                            worst_name_ + ")",
                        worst_, 1 + 1e-12);
}

}  // namespace incision::report
