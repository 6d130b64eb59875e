#pragma once

#include <array>
#include <vector>

#include "incision/surface/surface.h"

namespace incision {

/// Where the sides of a surface's triangles bend, so that the skin looks as round as it is meant to be when each
/// triangle is drawn as four: the vertices stay where they are, the points between them come out onto the curved side
/// of a "PN triangle" (Vlachos, Peters, Boyd and Mitchell, "Curved PN Triangles", 2001, equations for b210 and b120).
/// Sides of cut faces, and those that are sharp at rest, stay straight. What is drawn is as closed as the surface.
class Rounding {
 public:
  /// `rest`: where the vertices are at rest [m].
  Rounding(const Surface& surface, const std::vector<Vec3>& rest);

  /// Of each triangle, the number of the side from its first vertex to the second, to the third, and back.
  const std::vector<std::array<int, 3>>& sides() const { return sides_; }

  /// The point between the two ends of each side while the vertices are at `x` [m]. `surface`: that of the constructor.
  std::vector<Vec3> middles(const Surface& surface, const std::vector<Vec3>& x) const;

 private:
  struct Side {
    std::array<int, 2> ends;       ///< vertices, the lower first
    std::array<int, 2> triangles;  ///< beside it, where it bends
    std::array<int, 2> fans;       ///< of which the ends are, where it bends
    bool bends = false;
  };
  void findSides(const Surface& surface);
  void findFans(const Surface& surface);

  std::vector<Side> sides_of_all_;
  std::vector<std::array<int, 3>> sides_;
  /// The fan of each corner of the triangles: those round a vertex that hang together across sides that bend.
  std::vector<int> fan_of_corner_;
  int fans_ = 0;
};

}  // namespace incision
