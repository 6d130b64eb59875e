#pragma once

#include <vector>

#include "incision/cut/crack.h"
#include "incision/mesh/grid_mesh.h"

namespace incision::report {

/// Into how many zones planes part a box, from the planes alone: one, and one more for each plane that meets the box,
/// for each two whose line meets it, and for each three whose point lies in it. No four may meet in a point, no three
/// in a line, and no two be parallel.
int zonesOfPlanes(const GridSettings& box, const std::vector<PlaneCut>& planes);

/// The same of planes in any position, by sorting random points of the box by their sides; zones that hold none of
/// `points` points are missed.
int zonesBySampling(const GridSettings& box, const std::vector<PlaneCut>& planes, int points);

}  // namespace incision::report
