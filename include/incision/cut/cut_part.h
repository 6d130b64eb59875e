#pragma once

#include <array>
#include <vector>

#include "incision/cut/part.h"

namespace incision {

/// The material of one element on one side of all its cracks. Each part sees the whole element, through four copies of
/// its own choice. Of an element that a crack has cut through, in the plane:
///
///        2                  2'
///       / \                . .         The upper part contains node 2. It uses the own copy of 2, and extended
///      /   \ upper        .   .        copies 0' and 1' of the nodes that lie beyond the crack.
///     ╞═════╡            ╞═════╡       The lower part contains nodes 0 and 1. It uses their own copies, and an
///    .       .          /       \      extended copy 2'.
///   0' . . . 1'        0─────────1
///                          lower
///
struct Part {
  int element;
  std::array<int, 4> copies;  ///< c(p, I): the copy of each of the element's nodes that the part uses
  double fraction;            ///< w_p = V_p / V_e
  int detail;                 ///< index of its CutPart, or −1: the whole element, met by no crack
  int next;                   ///< next part of the same element, or −1; the first part of element e is part e
};

template <class Archive>
void serialize(Archive& archive, Part& part) {
  auto& [element, copies, fraction, detail, next] = part;
  archive(element, copies, fraction, detail, next);
}

/// On which side of a crack a part lies that has a whole face in the crack.
struct FaceSide {
  int face, crack, side;  ///< side: +1 or −1
};

template <class Archive>
void serialize(Archive& archive, FaceSide& side_of_face) {
  auto& [face, crack, side] = side_of_face;
  archive(face, crack, side);
}

/// What only a part that some crack has met needs.
struct CutPart {
  Polytope polytope;
  Barycentric centroid;
  Eigen::Matrix4d products;  ///< ∫_p N_I N_J dX / V_e
  std::vector<FaceSide> face_sides;
};

template <class Archive>
void serialize(Archive& archive, CutPart& part) {
  auto& [polytope, centroid, products, face_sides] = part;
  archive(polytope, centroid, products, face_sides);
}

}  // namespace incision
