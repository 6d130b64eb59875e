#pragma once

#include <optional>

#include "incision/contact/piece_trees.h"
#include "incision/contact/skin_in_step.h"

namespace incision {

/// A sample and the triangle that it is before, or just behind.
struct FaceMeeting {
  int sample, triangle;
  Vec3 normal;   ///< of the triangle when they meet in the step, or are nearest to that; unit
  Vec3 weights;  ///< of the triangle's corners at the foot of the sample then
  double gap;    ///< along the normal when the step starts [m]
};

/// Whether a sample may meet a triangle in the step: it faces it, or its vertex is the foremost of all around it, and
/// its foot is on the triangle when it comes to its plane.
std::optional<FaceMeeting> meetFace(const SkinInStep& skin, int sample, int triangle);

/// How deep a vertex is inside a surface.
struct Inside {
  double depth;  ///< 0 outside [m]
  Vec3 normal;   ///< of the nearest triangle
};

/// Of the closed surface of a piece, whose tree has been placed at these positions of the vertices [m]. Inside it a
/// vertex is behind the nearest triangle, and where an edge or a corner is nearest, behind that one of its triangles
/// which faces it most.
Inside insideOf(const ContactSurface& surface, const std::vector<Vec3>& x, int vertex, const PieceTrees& trees,
                int piece);

}  // namespace incision
