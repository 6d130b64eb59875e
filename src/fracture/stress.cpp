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

/// Whether some stress between the bounds is beyond the strength, or a bound is not a number.
bool mayBreak(const PrincipalBounds& bounds, const Strength& strength) {
  return !(bounds[1] <= strength.tensile && -bounds[0] <= strength.compressive);
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
  bounds_.resize(parts);
  marks_.resize(parts);
}

/// The mean by volume of what a part and its neighbours have.
template <typename Value>
Value SmoothedStress::mean(const Assembly& assembly, const std::vector<Value>& values, int part) const {
  double volume = assembly.volume(part);
  Value sum = volume * values[part];
  for (int neighbour : neighbours_[part]) {
    const double V = assembly.volume(neighbour);
    sum += V * values[neighbour];
    volume += V;
  }
  return sum / volume;
}

// The largest principal stress is a convex function of the stress, the smallest a concave one: that of a mean lies
// between the means of the bounds. Neighbours share a region, so where all of them bear what they have, so does their
// mean.
bool SmoothedStress::findSuspects(const Assembly& assembly, const std::vector<Vec3>& x,
                                  const std::vector<Strength>& strengths, std::vector<char>* suspects) {
  const int parts = static_cast<int>(raw_.size());
  const auto strengthOf = [&](int p) -> const Strength& {
    return strengths[assembly.materials().regions().of(assembly.mesh().parts()[p].element)];
  };
  assembly.principalBounds(x, &bounds_);
  parallelFor(parts, assembly.threads(), [&](int p) { marks_[p] = mayBreak(bounds_[p], strengthOf(p)); });
  const auto isMarked = [&](int p) { return marks_[p] != 0; };
  if (std::none_of(marks_.begin(), marks_.end(), [](char mark) { return mark != 0; })) return false;
  parallelFor(parts, assembly.threads(), [&](int p) {
    const bool any = isMarked(p) || std::any_of(neighbours_[p].begin(), neighbours_[p].end(), isMarked);
    (*suspects)[p] = any && mayBreak(mean(assembly, bounds_, p), strengthOf(p));
  });
  return std::any_of(suspects->begin(), suspects->end(), [](char suspect) { return suspect != 0; });
}

void SmoothedStress::update(const Assembly& assembly, const std::vector<Vec3>& x) {
  assembly.stresses(x, &raw_);
  parallelFor(static_cast<int>(raw_.size()), assembly.threads(),
              [&](int p) { smoothed_[p] = mean(assembly, raw_, p); });
}

void SmoothedStress::update(const Assembly& assembly, const std::vector<Vec3>& x, const std::vector<char>& wanted) {
  const int parts = static_cast<int>(raw_.size());
  parallelFor(parts, assembly.threads(), [&](int p) {
    marks_[p] =
        wanted[p] || std::any_of(neighbours_[p].begin(), neighbours_[p].end(), [&](int q) { return wanted[q]; });
  });
  assembly.stresses(x, marks_, &raw_);
  parallelFor(parts, assembly.threads(), [&](int p) {
    if (wanted[p]) smoothed_[p] = mean(assembly, raw_, p);
  });
}

}  // namespace incision
