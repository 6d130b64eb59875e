#pragma once

#include <array>
#include <map>
#include <string>
#include <utility>

#include "incision/rigid/solid.h"

namespace incision {

/// The meshes that one description names, each of them once for all collisions that have it.
class MeshFiles {
 public:
  /// `description` is the file that names them, from whose folder relative paths start, or something else.
  explicit MeshFiles(const std::string& description);

  /// `where` is the first place that names the mesh.
  SolidPtr at(const std::string& address, const Vec3& scale, const std::string& where);

 private:
  std::string folder_;  // empty: none
  std::map<std::pair<std::string, std::array<double, 3>>, SolidPtr> meshes_;
};

}  // namespace incision
