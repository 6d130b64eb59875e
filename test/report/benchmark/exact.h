#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "support/rig.h"

namespace incision::report {

/// What lies in a box at rest moves by so much [m], as the nodes in another box do.
struct Zone {
  RestBox box;
  Vec3 moved;
  RestBox clamp;
};

/// Cracks that part a body into zones, each of which is moved by itself: the answer is their rigid motion.
struct ZonesCase {
  const char *problem, *published;
  TetMesh mesh;
  double size;  ///< of the body [m]
  std::vector<PlaneCut> cuts;
  std::vector<Zone> zones;
};

/// The cases as they are published.
std::vector<ZonesCase> publishedZones();

/// Errors of these, and of junctions all within one element.
nlohmann::json rigidZones();

}  // namespace incision::report
