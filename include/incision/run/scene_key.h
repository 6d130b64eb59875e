#pragma once

#include <cstdint>

#include "incision/body/deformable_body.h"

namespace incision {

/// What two bodies have alike when one can go on where the other was saved.
struct SceneKey {
  std::uint64_t scene = 0;  ///< hash of all that the scene says but `solver.threads`, and of the files that it names
  std::uint64_t mesh = 0;   ///< hash of the mesh as it stands in the body, its groups included
  std::int64_t nodes = 0, elements = 0;
};

template <class Archive>
void serialize(Archive& archive, SceneKey& key) {
  auto& [scene, mesh, nodes, elements] = key;
  archive(scene, mesh, nodes, elements);
}

/// Of a body made with these descriptions. Values count, not how a file writes them; of files that a scene names the
/// content counts, not the path.
SceneKey keyOf(const DeformableBody& body, const Descriptions& descriptions);

}  // namespace incision
