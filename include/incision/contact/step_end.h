#pragma once

#include <utility>
#include <vector>

#include "incision/contact/candidate.h"
#include "incision/contact/near_pairs.h"

namespace incision {

/// Looks at the contacts of the body with itself where a step ends. They are reckoned along straight ways, with normals
/// and feet that stay: what turns in the step may be elsewhere.
class StepEnd {
 public:
  /// Whether none is deeper than was reckoned by more than is allowed in this share of the body's step. `moved`: by how
  /// far the candidates' points went [m]; `x`: where the vertices are [m]. Leaves the trees of `pairs` there.
  bool isAsReckoned(const ContactSurface& surface, const std::vector<Candidate>& candidates, Span<const Vec3> moved,
                    double share, const std::vector<Vec3>& x, NearPairs* pairs, int threads);

 private:
  std::vector<std::pair<int, double>> suspects_;  // candidates behind the plane of their face, and their allowed depth
  std::vector<int> pieces_;                       // in which they may be
};

}  // namespace incision
