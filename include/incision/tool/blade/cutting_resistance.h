#pragma once

#include <vector>

#include "incision/fem/regions.h"

namespace incision {

/// What it takes an edge to cut, a metre of edge in the tissue.
struct CuttingResistance {
  double force = 0;      ///< F_c, against which it advances once it cuts [N/m],
  double viscosity = 0;  ///< η, what that grows by with the speed at which it does [N s/m²],
  double onset = 0;      ///< and what it takes beyond that where nothing is cut yet [N/m]
};

/// In each region: that of the tool where the region's settings don't say.
inline std::vector<CuttingResistance> inRegions(const CuttingResistance& of_tool, const Regions& regions) {
  const std::vector<double> forces = regions.values(of_tool.force, &RegionSettings::cutting_force),
                            viscosities = regions.values(of_tool.viscosity, &RegionSettings::cutting_viscosity),
                            onsets = regions.values(of_tool.onset, &RegionSettings::cutting_onset);
  std::vector<CuttingResistance> all;
  for (std::size_t i = 0; i < forces.size(); ++i) all.push_back({forces[i], viscosities[i], onsets[i]});
  return all;
}

}  // namespace incision
