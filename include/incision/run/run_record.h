#pragma once

#include <fstream>
#include <string>

#include "incision/body/deformable_body.h"

namespace incision {

/// A table of a run in CSV: a header line, then one row a step, each row on disk before the next step begins.
class RunRecord {
 public:
  /// Throws InputError when the file cannot be created. `hashed`: a column has the hash of the state, as text.
  RunRecord(const std::string& path, const DeformableBody& body, bool hashed = false);

  /// Adds the row of the step just taken.
  void write(const DeformableBody& body, const StepResult& step);

  /// Whether everything written so far has reached the file.
  bool good() const { return file_.good(); }

 private:
  std::ofstream file_;
  bool hashed_;
};

}  // namespace incision
