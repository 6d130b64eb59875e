#pragma once

#include <vector>

#include "incision/contact/candidate.h"
#include "incision/contact/contact_surface.h"

namespace incision {

/// Writes to a touch where on the body it is, so that it is found again on a surface that is numbered in another way.
void tellPlace(const ContactSurface& surface, Touch* touch);

/// Gives touches the numbers that the surface has for their places, and leaves out those whose place it has no more.
void renumber(const ContactSurface& surface, std::vector<Touch>* touches);

}  // namespace incision
