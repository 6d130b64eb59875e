#pragma once

#include <string>
#include <vector>

#include "incision/body/deformable_body.h"
#include "incision/cut/cut_mesh.h"
#include "incision/scene/scene.h"

namespace incision {

/// What a user should be told of a scene that can be run but is hardly meant so, a line each: regions, clamps and loads
/// that lie where the body has nothing, a body that nothing holds, and a mesh whose unit may be another. `mesh` is the
/// body's.
std::vector<std::string> remarksOn(const Scene& scene, const CutMesh& mesh);

/// What was mended of the obstacles' and the tools' shapes when they were read.
std::vector<std::string> remarksOnShapes(const DeformableBody& body);

}  // namespace incision
