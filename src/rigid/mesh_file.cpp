#include "incision/rigid/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "incision/base/input_error.h"
#include "incision/base/printable.h"
#include "incision/base/read_text.h"
#include "incision/base/resolve_path.h"
#include "incision/rigid/read_triangle_mesh.h"

namespace incision {
namespace {

const std::string FILE_SCHEME = "file://";

/// Of a mesh's scale: from nanometres to what is measured in a thousand kilometres, either way round.
constexpr double LEAST_SCALE = 1e-9, MOST_SCALE = 1e9;

bool startsWith(const std::string& text, const std::string& start) { return text.compare(0, start.size(), start) == 0; }

std::string formatOf(const std::string& path) {
  std::string format = std::filesystem::path(path).extension().string();
  std::transform(format.begin(), format.end(), format.begin(), [](unsigned char c) { return std::tolower(c); });
  return format;
}

void checkScale(const Vec3& scale) {
  for (const double s : scale) {
    if (std::abs(s) >= LEAST_SCALE && std::abs(s) <= MOST_SCALE) continue;
    std::ostringstream text;
    text << "has the scale " << s << " (allowed: " << LEAST_SCALE << " to " << MOST_SCALE << ", or minus that)";
    throw InputError(text.str());
  }
}

}  // namespace

std::string MeshFile::path() const {
  if (startsWith(address_, FILE_SCHEME)) return resolvePath(address_.substr(FILE_SCHEME.size()), "/");
  const bool is_relative = address_.find("://") == std::string::npos && !startsWith(address_, "/");
  if (is_relative && folder_.empty()) {
    throw InputError("'" + printable(address_) +
                     "' is relative, and the description comes from no file (allowed: package://NAME/FILE or an "
                     "absolute path)");
  }
  return resolvePath(address_, folder_);
}

void MeshFile::read(const std::string& where) const {
  std::string what = where + ": mesh ";  // what is said of a path names it
  try {
    const std::string file = path(), bytes = readText(file, MAX_MESH_FILE);
    what += printable(address_) + " ";
    checkScale(scale_);
    TriangleMesh triangles = parseTriangleMesh(bytes, formatOf(file));
    for (Vec3& vertex : triangles.vertices) vertex = vertex.cwiseProduct(scale_);
    ClosedMesh closed = closeMesh(triangles, &remark_);
    if (!remark_.empty()) remark_ = "mesh " + printable(address_) + ": " + remark_;
    solid_ = std::make_unique<MeshSolid>(std::move(closed));
  } catch (const InputError& error) {
    throw InputError(what + error.what());
  }
}

std::string MeshFile::remark() const {
  solid();
  return remark_;
}

void MeshFile::check(const std::string& where) const {
  if (!solid_) read(where);
  solid_->check(where + ": mesh " + printable(address_));
}

// Whoever draws reads the file once for all that stand somewhere.
Drawing MeshFile::drawing() const {
  const bool is_package = startsWith(address_, "package://");
  return {Drawing::Primitive::MESH, scale_, is_package ? address_ : FILE_SCHEME + path(), nullptr};
}

}  // namespace incision
