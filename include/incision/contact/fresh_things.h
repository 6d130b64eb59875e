#pragma once

#include <utility>
#include <vector>

#include "incision/base/lists.h"
#include "incision/contact/near_test.h"
#include "incision/contact/surface_match.h"

namespace incision {

/// A sample that may meet a triangle.
struct SampleTriangle {
  int sample, triangle;
};

/// What of each piece of a surface was not there before the surface changed, and a search for what is near just that.
class FreshThings {
 public:
  void surfaceChanged(const ContactSurface& surface, const SurfaceMatch& known);

  bool any(int piece) const { return count(piece) > 0; }
  /// Whether it is so little that a search by it alone takes less time than one by all things of the piece.
  bool isLittle(int piece) const;

  /// Adds the samples of piece a that may meet triangles of piece b, with the vertices at `x` [m], where one of the two
  /// is fresh.
  void addFaces(const ContactSurface& surface, const std::vector<Vec3>& x, int a, int b, const Reach& reach,
                std::vector<SampleTriangle>* faces) const;

  /// Adds the edges of piece a and of another piece b that may meet, where one of the two is fresh.
  void addEdges(const ContactSurface& surface, const std::vector<Vec3>& x, int a, int b, double further,
                std::vector<std::pair<int, int>>* edges) const;

 private:
  int count(int piece) const { return triangles_[piece].size() + samples_[piece].size() + edges_[piece].size(); }

  Lists<int> triangles_, samples_, edges_;              // fresh ones of each piece,
  Lists<int> all_triangles_, old_samples_, all_edges_;  // and those that they are held against
  std::vector<char> is_fresh_edge_;
};

}  // namespace incision
