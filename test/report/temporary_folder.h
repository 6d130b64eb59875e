#pragma once

#include <stdlib.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace incision::report {

/// A folder for the files of another program; it goes with its owner.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "incision_XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no folder for temporary files");
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return path_ + "/" + name; }

  /// Runs a command of the shell. Throws std::runtime_error when it fails.
  void run(const std::string& command) const {
    if (std::system(("(" + command + ") > " + file("log") + " 2>&1").c_str()) != 0)
      throw std::runtime_error("this has failed, or is not installed: " + command);
  }

 private:
  std::string path_;
};

}  // namespace incision::report
