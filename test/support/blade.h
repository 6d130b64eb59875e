#pragma once

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "incision/body/deformable_body.h"
#include "incision/cut/section.h"
#include "support/tool.h"

namespace incision {

inline Pose poseAt(double x, double y, double z = 0) {
  Pose pose;
  pose.position = Vec3(x, y, z);
  return pose;
}

/// A plate of 1 × 0.5 × 0.25 m, free and without gravity, and a blade along z that reaches through it. It has `cells`
/// cells over its width.
inline Scene plateAndBlade(int cells = 4) {
  Scene scene;
  scene.body.grid = GridSettings{{2 * cells, cells, (cells + 1) / 2}, Vec3(1, 0.5, 0.25), Vec3::Zero()};
  scene.body.material = {1e5, 0.3, 1000, 0, 0};
  scene.gravity = Vec3::Zero();
  scene.solver.method = Method::DIRECT;
  scene.tools = {bladeTool(Edge{Vec3(0, 0, -0.1), Vec3(0, 0, 0.35)})};
  return scene;
}

/// The size of its elements [m].
inline double cellOf(const Scene& scene) { return scene.body.grid->size.y() / scene.body.grid->cells[1]; }

/// Draws the blade through `poses`, so many of them a step; the strokes that ended.
inline std::vector<CutResult> draw(DeformableBody* body, const std::vector<Pose>& poses, std::size_t a_step = 1) {
  std::vector<CutResult> ended;
  for (std::size_t k = 0; k < poses.size(); k += a_step) {
    body->guideTool({poses.begin() + static_cast<std::ptrdiff_t>(k),
                     poses.begin() + static_cast<std::ptrdiff_t>(std::min(poses.size(), k + a_step))});
    for (const CutResult& cut : body->step().cuts) ended.push_back(cut);
  }
  return ended;
}

/// Poses at shares 0 … 1 of a path that gives a pose for a share.
template <typename Path>
std::vector<Pose> along(int moves, const Path& path) {
  std::vector<Pose> poses;
  for (int k = 0; k <= moves; ++k) poses.push_back(path(k / static_cast<double>(moves)));
  return poses;
}

/// Corners of all cut faces, at rest [m].
inline std::vector<Vec3> cutCorners(const CutMesh& mesh) {
  std::vector<Vec3> corners;
  for (std::size_t p = 0; p < mesh.parts().size(); ++p) {
    const Polytope& polytope = mesh.polytope(static_cast<int>(p));
    for (const Facet& facet : polytope.facets) {
      if (facet.crack < 0) continue;
      for (const Barycentric& b : cornersOf(polytope, facet))
        corners.push_back(atRest(mesh, mesh.parts()[p].element, b));
    }
  }
  return corners;
}

/// Vector area of all cut faces of the positive and the negative sides: its length is twice the cut's area where that
/// is plane [m²].
inline double cutArea(const CutMesh& mesh) {
  double area = 0;
  for (std::size_t p = 0; p < mesh.parts().size(); ++p) {
    const Polytope& polytope = mesh.polytope(static_cast<int>(p));
    const auto resting = [&](const Barycentric& b) { return atRest(mesh, mesh.parts()[p].element, b); };
    for (const Facet& facet : polytope.facets)
      if (facet.crack >= 0) area += vectorArea(polytope, facet, resting).norm() / 2;
  }
  return area;
}

}  // namespace incision
