#include "incision/fem/materials.h"

#include <algorithm>
#include <cmath>

namespace incision {

Materials::Materials(const TetMesh& mesh, const Material& material, const std::vector<RegionSettings>& regions)
    : regions_(mesh, regions) {
  const auto young_moduli = regions_.values(material.young_modulus, &RegionSettings::young_modulus);
  const auto poisson_ratios = regions_.values(material.poisson_ratio, &RegionSettings::poisson_ratio);
  const auto densities = regions_.values(material.density, &RegionSettings::density);
  for (int r = 0; r < regions_.count(); ++r) {
    materials_.push_back(
        {young_moduli[r], poisson_ratios[r], densities[r], material.mass_damping, material.stiffness_damping});
    lame_.push_back(materials_[r].lame());
    // It depends on ν alone, but for rounding.
    const auto same = std::find(poisson_ratios.begin(), poisson_ratios.begin() + r, poisson_ratios[r]);
    const auto first = static_cast<int>(same - poisson_ratios.begin());
    ratio_of_.push_back(first < r ? ratio_of_[first] : static_cast<int>(ratios_.size()));
    if (first == r) ratios_.push_back(lame_[r].lambda / lame_[r].mu);
  }

  double volume = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const double one = elementVolume(mesh, static_cast<int>(e));
    sizes_.push_back(std::cbrt(6 * one));
    volume += one;
  }
  if (!sizes_.empty()) mean_size_ = std::cbrt(6 * volume / static_cast<double>(sizes_.size()));
}

}  // namespace incision
