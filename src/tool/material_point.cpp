#include "incision/tool/material_point.h"

#include "incision/tool/part_frame.h"

namespace incision {

void findMaterial(const std::vector<Vec3>& places, const std::vector<Vec3>& x, const CutMesh& mesh,
                  std::vector<std::optional<MaterialPoint>>* found) {
  found->assign(places.size(), std::nullopt);
  Eigen::AlignedBox3d around;
  for (const Vec3& place : places) around.extend(place);
  const int parts = static_cast<int>(mesh.parts().size());
  for (int p = 0; p < parts; ++p) {
    const Part& part = mesh.parts()[p];
    const Eigen::AlignedBox3d box = boxOf(part, x);
    if (!box.intersects(around)) continue;
    const PartFrame frame(part, x);
    if (!frame.invertible()) continue;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if ((*found)[i] || !box.contains(places[i])) continue;
      const Barycentric b = frame.toElement(places[i]);
      if (b.minCoeff() >= -OUTSIDE && encloses(mesh.polytope(p), b)) (*found)[i] = {part.element, b, p};
    }
  }
}

bool findPart(const CutMesh& mesh, MaterialPoint* material) {
  for (int p = material->element; p >= 0; p = mesh.parts()[p].next)
    if (encloses(mesh.polytope(p), material->point)) {
      material->part = p;
      return true;
    }
  return false;
}

}  // namespace incision
