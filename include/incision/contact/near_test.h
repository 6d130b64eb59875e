#pragma once

#include <vector>

#include "incision/contact/contact_surface.h"

namespace incision {

/// How far a search for what may meet looks [m]: from a triangle's plane, and within it beyond the triangle's edges.
struct Reach {
  double further, aside;
};

/// Whether a sample whose box is close to that of a triangle may come to meet it, with the vertices at `x` [m]: it is
/// above or below it, or within reach of that. Never where the triangle has no area at rest or the sample's vertex for
/// a corner; nor, `of_one_piece`, where there was material in between at rest, or the two lie beside each other on one
/// flat side.
bool mayMeet(const ContactSurface& surface, const std::vector<Vec3>& x, int sample, int triangle, const Reach& reach,
             bool of_one_piece);

}  // namespace incision
