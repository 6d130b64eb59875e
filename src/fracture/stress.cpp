#include "incision/fracture/stress.h"

#include <algorithm>
#include <utility>

#include "incision/base/parallel.h"
#include "incision/cut/section.h"
#include "incision/fracture/fringe.h"

namespace incision {
namespace {

/// Whether a crack that splits the part ends at this face of it, so that it does not split the part across.
bool crackEndsAt(const CutMesh& mesh, int part, int face, int across) {
  const Polytope& polytope = mesh.polytope(part);
  return std::any_of(polytope.facets.begin(), polytope.facets.end(), [&](const Facet& facet) {
    return facet.face < 0 && reaches(facet, face, polytope) && !facetOf(mesh.polytope(across), facet.crack);
  });
}

/// All pairs of parts of one region that share a face, are not severed there, and of which not one alone is split by a
/// crack that reaches the face.
std::vector<std::pair<int, int>> joinedParts(const CutMesh& mesh, const Regions& regions) {
  std::vector<std::pair<int, int>> joined;
  joined.reserve(2 * mesh.parts().size());
  const auto& neighbours = mesh.topology().neighbours;
  for (int e = 0; e < static_cast<int>(neighbours.size()); ++e)
    for (int face = 0; face < 4; ++face) {
      const int across = neighbours[e][face];
      if (across < e) continue;  // the boundary, or seen from the other side
      if (regions.of(across) != regions.of(e)) continue;
      if (mesh.isWhole(e) && mesh.isWhole(across)) {
        joined.emplace_back(e, across);
        continue;
      }
      const int back = faceTowards(mesh.topology(), across, e);
      for (const FacePair& pair : mesh.facePairs(e, face))
        if (!pair.severed_by && !crackEndsAt(mesh, pair.part, face, pair.other) &&
            !crackEndsAt(mesh, pair.other, back, pair.part))
          joined.emplace_back(pair.part, pair.other);
    }
  return joined;
}

}  // namespace

void SmoothedStress::topologyChanged(const Assembly& assembly) {
  const std::size_t parts = assembly.mesh().parts().size();
  const std::vector<std::pair<int, int>> joined = joinedParts(assembly.mesh(), assembly.materials().regions());
  neighbours_.sort(static_cast<int>(parts), [&](const auto& add) {
    for (const auto& [p, q] : joined) {
      add(p, q);
      add(q, p);
    }
  });
  raw_.resize(parts);
  smoothed_.resize(parts);
}

void SmoothedStress::update(const Assembly& assembly, const std::vector<Vec3>& x) {
  const int parts = static_cast<int>(raw_.size());
  assembly.stresses(x, &raw_);
  parallelFor(parts, assembly.threads(), [&](int p) {
    double volume = assembly.volume(p);
    Mat3 sum = volume * raw_[p];
    for (int neighbour : neighbours_[p]) {
      const double V = assembly.volume(neighbour);
      sum += V * raw_[neighbour];
      volume += V;
    }
    smoothed_[p] = sum / volume;
  });
}

}  // namespace incision
