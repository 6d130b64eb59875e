#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace incision::report {

/// What a section of the report measured, and what it claims by that. Its program is called with
///   --output FILE.json  where the findings go
///   --quick             smaller meshes and fewer cases, for a run of a minute at most
class Findings {
 public:
  /// Ends the program with exit status 2 and the usage when the arguments are others.
  Findings(int argc, char** argv);

  bool quick() const { return quick_; }

  /// What the section draws its plots and tables from; its keys are the section's own.
  nlohmann::json& data() { return data_; }

  /// Claims that must hold on any machine, so never of a wall time. Each is printed as it is made.
  void claimBelow(const std::string& what, double value, double bound);
  void claimAbove(const std::string& what, double value, double bound);
  void claim(const std::string& what, bool holds);

  /// Writes the file; returns the exit status: 1 where a claim does not hold or the file cannot be written.
  int write() const;

 private:
  void add(const std::string& what, const std::string& measured, const std::string& wanted, bool holds);

  std::string path_;
  bool quick_ = false;
  nlohmann::json data_ = nlohmann::json::object();
  nlohmann::json claims_ = nlohmann::json::array();
};

}  // namespace incision::report
