#include "report/regions/layered_beam.h"

#include <cmath>

namespace incision::report {

LayeredBeam::LayeredBeam(const std::vector<Layer>& layers, double width) {
  double stretch = 0, moment = 0;  // Σ E_k A_k / b, Σ E_k A_k z_k / b
  for (const Layer& layer : layers) {
    const double part = layer.young_modulus * (layer.top - layer.bottom);
    stretch += part;
    moment += part * (layer.top + layer.bottom) / 2;
  }
  neutral_ = moment / stretch;
  const auto cube = [&](double z) { return std::pow(z - neutral_, 3); };
  for (const Layer& layer : layers)
    stiffness_ += width * layer.young_modulus * (cube(layer.top) - cube(layer.bottom)) / 3;

  // τ = S / Σ E_k I_k with S = ∫ E (z − z₀) dz from z to the top: a parabola in each layer, so that its square is
  // integrated exactly by three points of Gauss.
  constexpr double POINT = 0.7745966692414834, OUTER = 5.0 / 18, INNER = 8.0 / 18;
  const auto square = [&](double z) { return (z - neutral_) * (z - neutral_); };
  shares_.assign(layers.size(), 0);
  double above = 0;  // S at the layer's top
  for (std::size_t k = layers.size(); k-- > 0;) {
    const Layer& layer = layers[k];
    const double height = layer.top - layer.bottom, G = layer.young_modulus / 2;
    for (const auto& [at, weight] : {std::pair(-POINT, OUTER), std::pair(0.0, INNER), std::pair(POINT, OUTER)}) {
      const double z = (layer.bottom + layer.top + at * height) / 2;
      const double tau = (above + layer.young_modulus * (square(layer.top) - square(z)) / 2) / stiffness_;
      shares_[k] += weight * height * width * tau;
      shear_ += weight * height * width * tau * tau / G;
    }
    above += layer.young_modulus * (square(layer.top) - square(layer.bottom)) / 2;
  }
}

}  // namespace incision::report
