#include "incision/fem/regions.h"

namespace incision {

Regions::Regions(const TetMesh& mesh, const std::vector<RegionSettings>& settings) : settings_(settings) {
  if (settings_.empty()) return;
  region_of_.assign(mesh.elements.size(), 0);
  for (std::size_t i = 0; i < settings_.size(); ++i)
    for (int e : elementsAt(settings_[i].place, mesh)) region_of_[e] = static_cast<int>(i) + 1;
}

std::string Regions::name(int region) const {
  if (region == 0) return "body";
  const std::string& group = settings_[region - 1].place.group;
  return group.empty() ? "region_" + std::to_string(region - 1) : group;
}

std::vector<std::optional<double>> Regions::values(std::optional<double> own,
                                                   std::optional<double> RegionSettings::*said) const {
  std::vector<std::optional<double>> values = {own};
  for (const RegionSettings& region : settings_) values.push_back(region.*said ? region.*said : own);
  return values;
}

std::vector<double> Regions::values(double own, std::optional<double> RegionSettings::*said) const {
  std::vector<double> values;
  for (const std::optional<double>& value : this->values(std::optional<double>(own), said)) values.push_back(*value);
  return values;
}

}  // namespace incision
