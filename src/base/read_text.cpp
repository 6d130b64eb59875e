#include "incision/base/read_text.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "incision/base/input_error.h"
#include "incision/base/printable.h"

namespace incision {

std::string readText(const std::string& path, std::size_t max_bytes) {
  const std::string name = printable(path);
  std::error_code unknown;
  if (std::filesystem::is_directory(path, unknown)) throw InputError(name + ": a folder (allowed: a file)");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(name + ": cannot be opened: " + std::strerror(errno));
  std::string text(max_bytes + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) throw InputError(name + ": cannot be read: " + std::strerror(errno));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > max_bytes) {
    throw InputError(name + ": the file is too large (allowed: up to " + std::to_string(max_bytes) + " bytes)");
  }
  return text;
}

}  // namespace incision
