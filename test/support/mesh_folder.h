#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace incision::test {

/// A folder for meshes that lives as long as the test.
class MeshFolder {
 public:
  explicit MeshFolder(const std::string& name)
      : folder_(std::filesystem::path(::testing::TempDir()) / (name + "_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~MeshFolder() { std::filesystem::remove_all(folder_); }
  MeshFolder(const MeshFolder&) = delete;
  MeshFolder& operator=(const MeshFolder&) = delete;

  std::string at(const std::string& file) const { return (folder_ / file).string(); }

  /// Writes the file and returns a URDF shape of it.
  std::string shape(const std::string& file, const std::string& bytes, const std::string& scale = "1 1 1") const {
    std::filesystem::create_directories((folder_ / file).parent_path());
    std::ofstream(folder_ / file, std::ios::binary) << bytes;
    return "<mesh filename='" + at(file) + "' scale='" + scale + "'/>";
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace incision::test
