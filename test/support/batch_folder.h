#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "incision/run/batch.h"

namespace incision {

/// A folder of this test's own with a small bar in it, half of which is cut off in mid-run.
class BatchFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(::testing::TempDir()) / ("batch_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    std::ofstream(file("bar.yaml")) << R"(
body: {grid: {cells: [4, 1, 1], size: [1, 0.25, 0.25]}}
boundary: [{box: [[-1, -1, -1], [1.0e-6, 1, 1]]}]
solver: {method: direct, threads: 1}
cuts:
  - {time: 0.02, label: middle, point: [0.6, 0, 0], normal: [1, 0, 0]}
  - {time: 0.02, label: beside, point: [9, 0, 0], normal: [1, 0, 0]}
)";
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string file(const std::string& name) const { return (folder_ / name).string(); }

  /// Runs the batch program, whose output and errors are then in `out_` and `err_`.
  BatchStatus run(std::vector<std::string> arguments) {
    out_.str("");
    err_.str("");
    return runBatch(arguments, out_, err_);
  }

  /// The lines of a file of the folder.
  std::vector<std::string> lines(const std::string& name) const {
    std::ifstream in(file(name));
    std::vector<std::string> all;
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
  }

  std::filesystem::path folder_;
  std::ostringstream out_, err_;
};

}  // namespace incision
