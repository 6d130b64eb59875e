#pragma once

#include <string>

#include "incision/body/deformable_body.h"
#include "support/rig.h"
#include "support/scenes.h"

namespace incision::test {

/// A block of cells of 0.05 m that may touch the ground at z = 0, its lowest corner at `origin`; gravity acts, and what
/// swings is damped.
inline Scene blockAbove(double ground, const std::array<int, 3>& cells, const Vec3& origin) {
  Scene scene;
  scene.body.grid = GridSettings{cells, 0.05 * Vec3(cells[0], cells[1], cells[2]), origin};
  scene.body.material = {1e5, 0.3, 1000, 0, 2e-3};
  scene.solver = {0.005, Method::DIRECT, 1e-8, 1};
  scene.contact = ContactSettings();
  scene.contact->ground = ground;
  return scene;
}

/// An element of such a block [m].
inline constexpr double ELEMENT = 0.05;

/// A block above the ground that falls apart along random planes.
inline Scene fallingToPieces(double young_modulus, int cells, int planes, unsigned seed) {
  Scene scene = blockAbove(0, {cells, cells, cells}, Vec3(0, 0, 0.001));
  scene.body.material = {young_modulus, 0.3, 1000, 0, 0};
  scene.solver.time_step = 0.01;
  scene.contact->friction = 0;
  const std::vector<Vec3> points = randomVectors(planes, 0.03, seed), normals = randomVectors(planes, 1, seed + 100);
  for (int k = 0; k < planes; ++k)
    scene.cuts.push_back({0, plane(Vec3::Constant(cells * ELEMENT / 2) + points[k], normals[k])});
  return scene;
}

/// A link "thing" with one collision shape, such as "<sphere radius='1'/>", at `xyz` and turned by `rpy`.
inline std::string urdfOf(const std::string& shape, const std::string& xyz = "0 0 0",
                          const std::string& rpy = "0 0 0") {
  return "<robot name='room'><link name='thing'><collision><origin xyz='" + xyz + "' rpy='" + rpy + "'/><geometry>" +
         shape + "</geometry></collision></link></robot>";
}

/// A body of the scene, with obstacles beside or instead of the ground.
inline DeformableBody bodyAmong(Scene scene, const std::string& urdf) {
  scene.contact->obstacles = "room.urdf";
  return DeformableBody(scene, loadMesh(scene), {{}, urdf});
}

inline Vec3 centreOfMass(const DeformableBody& body) {
  Vec3 sum = Vec3::Zero();
  double volume = 0;
  const auto& mesh = body.mesh();
  for (std::size_t p = 0; p < mesh.parts().size(); ++p) {
    const Part& part = mesh.parts()[p];
    const double V = part.fraction * elementVolume(mesh.mesh(), part.element);
    const Barycentric centroid = mesh.centroid(static_cast<int>(p));
    for (int I = 0; I < 4; ++I) sum += V * centroid[I] * body.positions()[part.copies[I]];
    volume += V;
  }
  return sum / volume;
}

}  // namespace incision::test
