#pragma once

#include <optional>
#include <string>
#include <vector>

#include "incision/fem/region_settings.h"

namespace incision {

/// Which region each element is of: region 0 is what no other has taken, region i + 1 is entry i of the settings. Where
/// they overlap, later ones win.
class Regions {
 public:
  /// One region.
  Regions() = default;
  /// Throws InputError where the mesh has no such group.
  Regions(const TetMesh& mesh, const std::vector<RegionSettings>& settings);

  int count() const { return 1 + static_cast<int>(settings_.size()); }
  int of(int element) const { return region_of_.empty() ? 0 : region_of_[element]; }
  bool areOne() const { return region_of_.empty(); }

  /// "body"; the name of its group; "region_i" where entry i has a box, from 0.
  std::string name(int region) const;

  /// A value for each region: the body's own where the region's settings don't say.
  std::vector<double> values(double own, std::optional<double> RegionSettings::*said) const;
  std::vector<std::optional<double>> values(std::optional<double> own,
                                            std::optional<double> RegionSettings::*said) const;

 private:
  std::vector<RegionSettings> settings_;
  std::vector<int> region_of_;  // of each element
};

}  // namespace incision
