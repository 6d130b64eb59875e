#pragma once

#include <string>

#include "incision/cut/cut_result.h"
#include "incision/pace/command.h"

namespace incision {

/// Least time [s] between two warnings about one thing.
inline constexpr double WARNING_PERIOD = 2;

/// Who is told what becomes of commands. May be told from two threads. Throws nothing: where memory runs out it waits
/// for some, and where there is none for long it tells less.
class Answers {
 public:
  virtual ~Answers() = default;

  /// A cut that the body has answered.
  virtual void report(const CutResult& result) = 0;

  /// A cut, or what was asked of a tool, that did not get as far as the body.
  virtual void refuseCut(const std::string& label, const Refused& refused) = 0;
  virtual void refuseTool(int tool, const Refused& refused) = 0;

  /// What somebody should know; of warnings `about` one thing those that follow within WARNING_PERIOD are left out.
  /// There are no more such things than the scene has names.
  virtual void warn(const std::string& about, const std::string& text) = 0;
  virtual void inform(const std::string& text) = 0;
};

}  // namespace incision
