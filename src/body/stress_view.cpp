#include "incision/body/stress_view.h"

#include <algorithm>
#include <utility>

namespace incision {

StressView::StressView(std::shared_ptr<const CutMesh> mesh, const Materials& materials, const BodySettings& settings,
                       const std::vector<Vec3>& x)
    : mesh_(std::move(mesh)), assembly_(*mesh_, materials, settings.mass, settings.pressure, settings.warping, 1) {
  assembly_.topologyChanged(x);
}

std::vector<double> StressView::vonMises(const std::vector<Vec3>& x) {
  std::vector<Mat3> stresses;
  assembly_.stresses(x, &stresses);
  std::vector<double> result;
  result.reserve(stresses.size());
  for (const Mat3& stress : stresses) result.push_back(incision::vonMises(stress));
  assembly_.rotate(x);  // the next guess
  return result;
}

std::vector<RegionStress> StressView::ofRegions(const std::vector<double>& of_parts) const {
  const Regions& regions = assembly_.materials().regions();
  std::vector<RegionStress> stress(regions.count());
  std::vector<double> volume(regions.count(), 0);
  for (std::size_t p = 0; p < of_parts.size(); ++p) {
    const int r = regions.of(mesh_->parts()[p].element);
    const double V = assembly_.volume(static_cast<int>(p));
    volume[r] += V;
    stress[r].mean += V * of_parts[p];
    stress[r].largest = std::max(stress[r].largest, of_parts[p]);
  }
  for (std::size_t r = 0; r < stress.size(); ++r)
    if (volume[r] > 0) stress[r].mean /= volume[r];
  return stress;
}

}  // namespace incision
