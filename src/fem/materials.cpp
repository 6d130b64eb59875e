#include "incision/fem/materials.h"

#include <cmath>

namespace incision {

Materials::Materials(const TetMesh& mesh, const Material& material) : material_(material) {
  double volume = 0;
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    const double one = elementVolume(mesh, static_cast<int>(e));
    sizes_.push_back(std::cbrt(6 * one));
    volume += one;
  }
  if (!sizes_.empty()) mean_size_ = std::cbrt(6 * volume / static_cast<double>(sizes_.size()));
}

}  // namespace incision
