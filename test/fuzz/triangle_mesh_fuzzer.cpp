// Whatever a mesh file is, reading it gives a solid with finite distances or an InputError.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "incision/base/input_error.h"
#include "incision/rigid/mesh_solid.h"
#include "incision/rigid/read_triangle_mesh.h"

namespace {

using namespace incision;

void require(bool holds) {
  if (!holds) std::abort();
}

void requireValid(const MeshSolid& solid) {
  try {
    solid.check("here");
  } catch (const InputError&) {
    return;  // of a size that nobody has
  }
  require(solid.thickness() > 0 && std::isfinite(solid.reach()));
  for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.6, 0, 0.8)}) {
    for (const double share : {0.0, 0.5, 2.0}) {
      const Vec3 point = share * solid.reach() * direction;
      const SolidDistance distance = solid.distanceTo(point);
      require(std::isfinite(distance.distance) && std::abs(distance.normal.norm() - 1) < 1e-6);
      require(share < 2 || distance.distance > 0);
      require(share < 2 || solid.isClearOf(point, 0));
    }
    require(solid.reachAlong(direction) <= solid.reach() * (1 + 1e-12));
  }
}

/// What a file of the corpus, or made from one, begins with.
const char* formatOf(const std::string& bytes) {
  if (bytes[0] == '<') return ".dae";
  return std::string("vfom#").find(bytes[0]) != std::string::npos ? ".obj" : ".stl";
}

}  // namespace

// assimp loses the meshes of some files that it refuses.
extern "C" const char* __lsan_default_suppressions() { return "leak:libassimp"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    std::string remark;
    requireValid(MeshSolid(closeMesh(parseTriangleMesh(bytes, formatOf(bytes)), &remark)));
  } catch (const InputError&) {
  }
  return 0;
}
