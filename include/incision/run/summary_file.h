#pragma once

#include <fstream>
#include <string>

namespace incision {

/// The file that a run's line of JSON is to be kept in. It is there whole or not at all: what is at its path stays as
/// it is until the line is written, beside it, to the end.
class SummaryFile {
 public:
  /// Creates PATH.tmp. Throws InputError where that is not possible.
  explicit SummaryFile(const std::string& path);
  /// Removes PATH.tmp where nothing was kept.
  ~SummaryFile();
  SummaryFile(const SummaryFile&) = delete;
  SummaryFile& operator=(const SummaryFile&) = delete;

  /// Puts the line, with its end, in its place. Returns whether that was possible.
  bool keep(const std::string& line);

 private:
  std::string path_, beside_;
  std::ofstream file_;
  bool kept_ = false;
};

}  // namespace incision
