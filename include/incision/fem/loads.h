#pragma once

#include <array>
#include <vector>

#include "incision/cut/cut_mesh.h"
#include "incision/fem/boundary_settings.h"

namespace incision {

/// What pulls and presses on a body's boundary. A traction t gives ∫ N_I t dA over the area at rest, a pressure p
///   −p ∫ N_I n da
/// over the area a as it is deformed by the copies of the part that owns it, n being its normal out of the body. As N_I
/// is linear and n da alike all over the face, that is −p (∫ N_I dA / A) ½ (x_B − x_A) × (x_C − x_A).
class Loads {
 public:
  /// Finds the loaded faces. `mesh` must outlive this. Throws InputError where a group is missing.
  Loads(const CutMesh& mesh, std::vector<Load> loads);

  /// Before use and after every change of the mesh: finds what each part owns of the faces.
  void topologyChanged();

  /// Whether any load is a pressure, so that the forces depend on positions.
  bool anyPresses() const { return any_presses_; }

  /// Adds the forces [N] at `time` [s] on copies that are at `x` [m].
  void addTo(double time, const std::vector<Vec3>& x, std::vector<Vec3>* forces) const;

 private:
  /// What a part owns of a face.
  struct Pressed {
    std::array<int, 3> copies;  ///< counter-clockwise seen from outside
    Vec3 shares;                ///< ∫ N_I dA / A over it
  };

  const CutMesh& mesh_;
  std::vector<Load> loads_;
  bool any_presses_ = false;
  std::vector<std::vector<ElementFace>> faces_;  // of each load
  std::vector<std::vector<Vec3>> tractions_;     // of each load, by copy [N]; none where it has no traction
  std::vector<std::vector<Pressed>> pressed_;    // of each load; none where it has no pressure
};

}  // namespace incision
