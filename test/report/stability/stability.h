#pragma once

#include "cases.h"

namespace incision::report {

/// The groups of cases, a file each.
void mapOfStiffness(Matrix* matrix);    ///< E × Δt, and ν: a cut bar that swings
void extremeShapes(Matrix* matrix);     ///< a bar driven out of all shape, by its ends or at once
void cutsAndGeometry(Matrix* matrix);   ///< what cuts leave, against counts of zones
void smallParts(Matrix* matrix);        ///< parts of hardly any volume, alone, in chains, beside each other
void manyCuts(Matrix* matrix);          ///< a thousand cuts, a thousand parts, strokes, 1e5 steps
void extremeMotion(Matrix* matrix);     ///< spinning, dead tension, impact, damping
void extremeElements(Matrix* matrix);   ///< flat, needle and sliver elements; stiffness beyond double
void contactEnsembles(Matrix* matrix);  ///< many runs of pieces that touch: falls, stacks, impacts, spin, blades

}  // namespace incision::report
