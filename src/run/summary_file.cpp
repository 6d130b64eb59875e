#include "incision/run/summary_file.h"

#include <cstdio>

#include "incision/run/output_file.h"

namespace incision {

SummaryFile::SummaryFile(const std::string& path) : path_(path), beside_(path + ".tmp"), file_(openOutput(beside_)) {}

SummaryFile::~SummaryFile() {
  if (!kept_) std::remove(beside_.c_str());
}

bool SummaryFile::keep(const std::string& line) {
  file_ << line << std::endl;
  if (!file_) return false;
  file_.close();
  kept_ = std::rename(beside_.c_str(), path_.c_str()) == 0;
  return kept_;
}

}  // namespace incision
