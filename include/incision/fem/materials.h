#pragma once

#include <vector>

#include "incision/fem/material.h"
#include "incision/mesh/tet_mesh.h"

namespace incision {

/// What the elements of a body are made of, how large they are, and so how stiff: springs that shall be as stiff as the
/// material round them take their measure from here.
class Materials {
 public:
  /// One material everywhere.
  Materials(const TetMesh& mesh, const Material& material);

  const Material& of(int /*element*/) const { return material_; }

  double youngModulus(int element) const { return of(element).young_modulus; }  ///< E [Pa]
  /// h = ∛(6 V_e) [m]: the edge of a cube that six such elements fill, and so a grid's cell.
  double size(int element) const { return sizes_[element]; }
  /// Size of an element of mean volume [m].
  double meanSize() const { return mean_size_; }
  /// E/h [Pa/m]: the pressure on an element that changes its height by one metre.
  double stiffness(int element) const { return youngModulus(element) / size(element); }

  /// λ/μ, which is that of every element: the assembly of the matrix takes it out of the sums over elements.
  double lameRatio() const { return material_.lambda() / material_.mu(); }
  /// α [1/s] and β [s] of C = α M + β K, for the whole body.
  double massDamping() const { return material_.mass_damping; }
  double stiffnessDamping() const { return material_.stiffness_damping; }

 private:
  Material material_;
  std::vector<double> sizes_;  // [m]
  double mean_size_ = 0;       // [m]
};

}  // namespace incision
