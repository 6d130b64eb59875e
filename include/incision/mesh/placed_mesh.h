#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "incision/base/vec.h"
#include "incision/mesh/tet_mesh.h"

namespace incision {

class YamlMap;

/// Most mesh files in a body. Each takes a name and a reading; more are a slip of the pen.
inline constexpr std::size_t MAX_MESHES = 1000;

/// A mesh file, and where its mesh stands in the body: x = rotation · scale · x_file + position.
struct PlacedMesh {
  std::string name = {};  ///< of the groups, NAME/GROUP, and of the whole as a group of volumes; none: as in the file
  std::string file = {};  ///< its absolute path
  double scale = 1;       ///< the file's unit in metres
  Mat3 rotation = Mat3::Identity();
  Vec3 position = Vec3::Zero();  ///< [m]
  std::string said_at = {};      ///< source and key, for messages
};

/// The mesh files that the keys `mesh` and `scale`, or else `meshes`, name, by name; none where there is no such key.
/// Throws InputError.
std::vector<PlacedMesh> parsePlacedMeshes(const YamlMap& body);

/// The mesh of a file in the units and in the place that it has in the body, its groups called as they are there. Where
/// it has a name, their numbers are not unique before joined() gives them new ones.
/// Throws InputError where it comes to lie beyond MAX_COORDINATE, or gets too small for its elements to have a volume.
TetMesh placed(TetMesh mesh, const PlacedMesh& at);

/// One mesh of several, which share no nodes; groups are numbered afresh in each dimension. Throws InputError where
/// there would be too many nodes or elements.
TetMesh joined(const std::vector<TetMesh>& meshes);

/// Reads, places and joins them all. What had to be mended is added to `notes`, each a sentence after its file's name.
TetMesh readPlacedMeshes(const std::vector<PlacedMesh>& meshes, std::vector<std::string>* notes = nullptr);

}  // namespace incision
