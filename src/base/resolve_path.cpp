#include "incision/base/resolve_path.h"

#include <tinyxml.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

#include "incision/base/input_error.h"
#include "incision/base/printable.h"

namespace incision {

namespace {

namespace fs = std::filesystem;

constexpr const char* SCHEME = "package://";

std::vector<fs::path> pathList(const char* variable) {
  const char* value = std::getenv(variable);
  std::istringstream entries(value ? value : "");
  std::vector<fs::path> paths;
  for (std::string entry; std::getline(entries, entry, ':');) {
    if (!entry.empty()) paths.emplace_back(entry);
  }
  return paths;
}

// Whether the folder's package.xml says that it is this package.
bool isPackage(const fs::path& folder, const std::string& name) {
  TiXmlDocument manifest;
  std::error_code unknown;
  const fs::path file = folder / "package.xml";
  if (!fs::is_regular_file(file, unknown) || !manifest.LoadFile(file.string())) return false;
  const TiXmlElement* title = TiXmlHandle(&manifest).FirstChild("package").FirstChild("name").ToElement();
  return title && title->GetText() && title->GetText() == name;
}

// Where a package may lie, likeliest first.
std::vector<fs::path> candidates(const std::string& name) {
  std::vector<fs::path> folders;
  for (const fs::path& entry : pathList("ROS_PACKAGE_PATH")) {
    folders.push_back(entry);
    folders.push_back(entry / name);
  }
  for (const fs::path& entry : pathList("CMAKE_PREFIX_PATH")) folders.push_back(entry / "share" / name);
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  if (!unknown) folders.push_back(program.parent_path() / "../../share" / name);  // of lib/incision/incision_batch
  folders.emplace_back(INCISION_SOURCE_DIR);
  return folders;
}

fs::path packageFolder(const std::string& name) {
  const char* letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  if (name.empty() || name.find_first_not_of(letters) != std::string::npos) {
    throw InputError("'" + printable(name) + "' is no package name (allowed: package://NAME/FILE)");
  }
  for (const fs::path& folder : candidates(name)) {
    if (isPackage(folder, name)) return folder;
  }
  throw InputError("package " + printable(name) + " not found (looked in ROS_PACKAGE_PATH and CMAKE_PREFIX_PATH)");
}

}  // namespace

std::string resolvePath(const std::string& address, const std::string& folder) {
  const std::string scheme(SCHEME);
  if (address.compare(0, scheme.size(), scheme) == 0) {
    const std::size_t slash = std::min(address.find('/', scheme.size()), address.size());
    const std::string package = address.substr(scheme.size(), slash - scheme.size());
    const std::string rest = slash < address.size() ? address.substr(slash + 1) : "";
    return (packageFolder(package) / fs::path(rest).relative_path()).lexically_normal().string();
  }
  if (address.empty() || address.find("://") != std::string::npos) {
    throw InputError("'" + printable(address) + "' (allowed: package://NAME/FILE or a path)");
  }
  return (fs::absolute(folder.empty() ? "." : folder) / address).lexically_normal().string();
}

}  // namespace incision
