#pragma once

#include <string>

#include "report/findings.h"

namespace incision::report {

/// The matrix of cases, in groups. What passes in a group becomes one claim.
class Matrix {
 public:
  explicit Matrix(Findings* findings) : findings_(findings) { findings->data()["cases"] = nlohmann::json::array(); }

  /// The cases from here on belong to this group.
  void begin(const std::string& group);

  /// A case passes when its figure is at most the bound; `reason` says where that comes from.
  void add(const std::string& name, double figure, double bound, const std::string& reason);
  /// A case that is known to fail: it is listed with its figure, and nothing is claimed of it.
  void addLimit(const std::string& name, double figure, double bound, const std::string& reason);

  /// Ends a group: claims that all of its cases but the limits pass.
  void end();

  bool quick() const { return findings_->quick(); }
  nlohmann::json& data() { return findings_->data(); }

 private:
  void list(const std::string& name, double figure, double bound, const std::string& reason, bool limit);

  Findings* findings_;
  std::string group_, worst_name_;
  double worst_ = 0;
  int count_ = 0;
};

}  // namespace incision::report
