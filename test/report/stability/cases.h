#pragma once

#include <string>

#include "report/section.h"

namespace incision::report {

/// The matrix of cases, in groups.
class Matrix {
 public:
  Matrix(bool quick, nlohmann::json* data) : quick_(quick), data_(data) {}

  /// The cases from here on belong to this group.
  void begin(const std::string& group) { group_ = group; }

  /// A case passes when its figure is at most the bound; `reason` says where that comes from.
  void add(const std::string& name, double figure, double bound, const std::string& reason) {
    list(name, figure, bound, reason, false);
  }
  /// A case that is known to fail: it is listed with its figure, and nothing is claimed of it.
  void addLimit(const std::string& name, double figure, double bound, const std::string& reason) {
    list(name, figure, bound, reason, true);
  }

  bool quick() const { return quick_; }
  nlohmann::json& data() { return *data_; }

 private:
  void list(const std::string& name, double figure, double bound, const std::string& reason, bool limit) {
    (*data_)["cases"].push_back({{"group", group_},
                                 {"name", name},
                                 {"figure", figure},
                                 {"bound", bound},
                                 {"reason", reason},
                                 {"limit", limit},
                                 {"passes", figure <= bound}});
  }

  bool quick_;
  nlohmann::json* data_;
  std::string group_;
};

}  // namespace incision::report
