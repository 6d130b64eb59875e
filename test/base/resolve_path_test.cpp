#include "incision/base/resolve_path.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "incision/base/input_error.h"

namespace incision {
namespace {

namespace fs = std::filesystem;

// A folder to make packages in, and environment variables that are put back.
class ResolvePath : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(::testing::TempDir()) / ("resolve_path_" + std::to_string(getpid()));
    fs::create_directories(root_);
    for (const char* name : {"ROS_PACKAGE_PATH", "CMAKE_PREFIX_PATH"}) {
      const char* value = std::getenv(name);
      saved_.emplace_back(name, value ? value : "");
      unsetenv(name);
    }
  }
  void TearDown() override {
    for (const auto& [name, value] : saved_) setenv(name.c_str(), value.c_str(), 1);
    fs::remove_all(root_);
  }

  fs::path makePackage(const fs::path& folder, const std::string& name) const {
    fs::create_directories(root_ / folder);
    std::ofstream(root_ / folder / "package.xml")
        << "<?xml version=\"1.0\"?>\n<!-- <name>other</name> -->\n<package format=\"2\"><name>" << name
        << "</name></package>\n";
    return root_ / folder;
  }

  fs::path root_;
  std::vector<std::pair<std::string, std::string>> saved_;
};

TEST_F(ResolvePath, EntryOfRosPackagePathMayBeThePackageItself) {
  const fs::path package = makePackage("somewhere", "tissue");
  setenv("ROS_PACKAGE_PATH", ("/no/such/folder::" + package.string()).c_str(), 1);
  EXPECT_EQ(resolvePath("package://tissue/meshes/a.msh", ""), (package / "meshes/a.msh").string());
}

TEST_F(ResolvePath, EntryOfRosPackagePathMayHoldThePackage) {
  const fs::path package = makePackage("src/tissue", "tissue");
  setenv("ROS_PACKAGE_PATH", (root_ / "src").c_str(), 1);
  EXPECT_EQ(resolvePath("package://tissue/a.msh", ""), (package / "a.msh").string());
}

TEST_F(ResolvePath, FolderOfThatNameWithAnotherPackageIsPassedOver) {
  makePackage("src/tissue", "bone");
  const fs::path package = makePackage("install/share/tissue", "tissue");
  setenv("ROS_PACKAGE_PATH", (root_ / "src").c_str(), 1);
  setenv("CMAKE_PREFIX_PATH", (root_ / "install").c_str(), 1);
  EXPECT_EQ(resolvePath("package://tissue/a.msh", ""), (package / "a.msh").string());
}

TEST_F(ResolvePath, OwnPackageIsFoundWithoutAnEnvironment) {
  EXPECT_TRUE(fs::exists(resolvePath("package://incision/config/scenes/bar.yaml", "")));
}

TEST_F(ResolvePath, UnknownPackagesAndOtherSchemesAreRefused) {
  for (const char* bad : {"package://tissue/a.msh", "package:///a.msh", "package://", "package://../a.msh",
                          "http://host/a.msh", "file:///a.msh", ""}) {
    EXPECT_THROW(resolvePath(bad, "/folder"), InputError) << bad;
  }
}

TEST_F(ResolvePath, RelativePathsStartAtTheFolder) {
  EXPECT_EQ(resolvePath("../b/a.msh", "/folder/a"), "/folder/b/a.msh");
  EXPECT_EQ(resolvePath("/b/a.msh", "/folder"), "/b/a.msh");
  EXPECT_EQ(resolvePath("a.msh", ""), (fs::current_path() / "a.msh").string());
}

}  // namespace
}  // namespace incision
