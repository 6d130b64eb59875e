#pragma once

#include <string>
#include <vector>

#include "incision/pace/answers.h"

namespace incision {

/// Remembers all it is told.
class AnswersInTests : public Answers {
 public:
  void report(const CutResult& result) override { reports.push_back(result); }
  void refuseCut(const std::string& label, const Refused& refused) override {
    refused_cuts.push_back(label);
    last = refused;
  }
  void refuseTool(int, const Refused& refused) override {
    ++refused_of_tools;
    last = refused;
  }
  void warn(const std::string&, const std::string& text) override { warnings.push_back(text); }
  void inform(const std::string&) override {}

  std::vector<CutResult> reports;
  std::vector<std::string> refused_cuts, warnings;
  int refused_of_tools = 0;
  Refused last;
};

}  // namespace incision
