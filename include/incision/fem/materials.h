#pragma once

#include <cmath>
#include <vector>

#include "incision/fem/material.h"
#include "incision/mesh/tet_mesh.h"

namespace incision {

class Materials {
 public:
  Materials(const TetMesh& mesh, const Material& material) : material_(material) {
    double volume = 0;
    for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
      size_.push_back(std::cbrt(6 * elementVolume(mesh, e)));
      volume += elementVolume(mesh, e);
    }
    mean_size_ = std::cbrt(6 * volume / static_cast<double>(mesh.elements.size()));
  }
  double size(int element) const { return size_[element]; }
  double meanSize() const { return mean_size_; }
  double youngModulus(int) const { return material_.young_modulus; }
  double stiffness(int element) const { return material_.young_modulus / size_[element]; }

 private:
  Material material_;
  std::vector<double> size_;
  double mean_size_;
};

}  // namespace incision
