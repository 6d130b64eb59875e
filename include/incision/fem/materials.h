#pragma once

#include <vector>

#include "incision/fem/material.h"
#include "incision/fem/regions.h"
#include "incision/mesh/tet_mesh.h"

namespace incision {

/// What the elements of a body are made of, how large they are, and so how stiff: springs that shall be as stiff as the
/// material round them take their measure from here.
class Materials {
 public:
  /// One material, but where a region has its own. Throws InputError where the mesh has no such group.
  Materials(const TetMesh& mesh, const Material& material, const std::vector<RegionSettings>& regions = {});

  const Regions& regions() const { return regions_; }
  const Material& of(int element) const { return materials_[regions_.of(element)]; }
  const Lame& lame(int element) const { return lame_[regions_.of(element)]; }

  double youngModulus(int element) const { return of(element).young_modulus; }  ///< E [Pa]
  /// h = ∛(6 V_e) [m]: the edge of a cube that six such elements fill, and so a grid's cell.
  double size(int element) const { return sizes_[element]; }
  /// Size of an element of mean volume [m].
  double meanSize() const { return mean_size_; }
  /// E/h [Pa/m]: the pressure on an element that changes its height by one metre.
  double stiffness(int element) const { return youngModulus(element) / size(element); }

  /// The different λ/μ that there are, and which of them an element has: the assembly of the matrix takes the ratio out
  /// of its sums over elements.
  const std::vector<double>& lameRatios() const { return ratios_; }
  int lameRatio(int element) const { return ratio_of_[regions_.of(element)]; }

  /// α [1/s] and β [s] of C = α M + β K, for the whole body.
  double massDamping() const { return materials_[0].mass_damping; }
  double stiffnessDamping() const { return materials_[0].stiffness_damping; }

 private:
  Regions regions_;
  std::vector<Material> materials_;  // of each region
  std::vector<Lame> lame_;           // of each region
  std::vector<double> ratios_;
  std::vector<int> ratio_of_;  // of each region
  std::vector<double> sizes_;  // [m]
  double mean_size_ = 0;       // [m]
};

}  // namespace incision
