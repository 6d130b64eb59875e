#pragma once

#include <cstddef>
#include <string>

#include "incision/rigid/triangle_mesh.h"

namespace incision {

/// A mesh file is refused beyond these sizes, the first in bytes: a scan of a whole room stays below, and what would
/// take minutes to read, or the memory of the node, does not.
inline constexpr std::size_t MAX_MESH_FILE = std::size_t{64} << 20;
inline constexpr std::size_t MAX_TRIANGLES = 1'000'000;

/// The formats that are read, as errors list them.
inline constexpr const char* MESH_FORMATS = ".stl, .obj or .dae";

/// All triangles of a mesh file, polygons cut into triangles. STL and OBJ are taken in metres; COLLADA's unit and the
/// places of its nodes are applied and its up axis is not, as rviz does. `format` is the end of the file's name, with
/// the dot. No file is opened. Throws InputError, in words that go on after the file's name, when `bytes` is no such
/// mesh, has no triangle or too many, or a coordinate that is not finite.
TriangleMesh parseTriangleMesh(const std::string& bytes, const std::string& format);

}  // namespace incision
