#pragma once

#include <cstdint>
#include <vector>

#include "incision/fem/regions.h"
#include "incision/fracture/settings.h"
#include "incision/mesh/tet_mesh.h"

namespace incision {

enum class FailureKind : std::uint8_t { TENSION = 0, COMPRESSION = 1 };

/// How close a stress comes to what the material bears.
struct Loading {
  double share = 0;   ///< of the strength; the material fails above 1
  double stress = 0;  ///< the principal stress [Pa] that decides
  FailureKind kind = FailureKind::TENSION;
};

/// The largest tension and compression that a tissue bears [Pa], > 0.
struct Strength {
  double tensile, compressive;
};

/// Of each region.
std::vector<Strength> strengthsOf(const FractureSettings& settings, const Regions& regions);

/// Rankine's criterion: the largest principal stress against the tensile strength, the smallest against the compressive
/// one; what comes closer to its strength decides. A stress that is not finite loads nothing.
Loading rankine(const Mat3& stress, const Strength& strength);

/// Unit normal of the crack that the stress opens: the direction of the largest principal stress, for either kind. In
/// tension the crack lies across the pull. In compression it lies along the direction of the smallest principal stress,
/// as slabs split off a crushed column do: across the push it would never open.
Vec3 crackNormal(const Mat3& stress);

}  // namespace incision
