#pragma once

#include <optional>
#include <vector>

#include "incision/cut/cut_mesh.h"

namespace incision {

/// A point of the material.
struct MaterialPoint {
  int element = 0;
  Barycentric point = Barycentric::Zero();  ///< in the element
  int part = 0;                             ///< of the element, which has the point
};

template <class Archive>
void serialize(Archive& archive, MaterialPoint& material) {
  auto& [element, point, part] = material;
  archive(element, point, part);
}

/// Finds what material is at each of these places [m], the copies being at `x` [m]: that of the first part that has the
/// place, none where no part has. Goes once over all parts.
void findMaterial(const std::vector<Vec3>& places, const std::vector<Vec3>& x, const CutMesh& mesh,
                  std::vector<std::optional<MaterialPoint>>* found);

/// Finds the part that has the point, as cuts may have split the one that had it. Returns false where rounding has left
/// none.
bool findPart(const CutMesh& mesh, MaterialPoint* material);

}  // namespace incision
