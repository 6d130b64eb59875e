#pragma once

#include <array>
#include <optional>
#include <vector>

#include "incision/base/lists.h"
#include "incision/cut/cut_mesh.h"
#include "incision/fem/linear_tet.h"
#include "incision/fem/mass.h"
#include "incision/fem/materials.h"
#include "incision/fem/patches.h"
#include "incision/fem/pressure.h"
#include "incision/fem/rotation.h"
#include "incision/fem/run_sums.h"

namespace incision {

/// One corner of a part: the part and the local node. There are four for every part, so they are packed.
struct Corner {
  unsigned part : 30, node : 2;
};

/// The least and the most that a principal stress [Pa] can be.
using PrincipalBounds = Eigen::Vector2d;

/// What ties each pair of a part's corners to one another by its tension, Δt² V_p b_I · S⁺ b_J [kg]. Those of a corner
/// with all four sum to zero.
struct TensionProducts {
  std::array<double, 6> pairs;  ///< 01, 02, 03, 12, 13, 23

  double of(int I, int J) const {
    constexpr int PLACE[4][4] = {{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}};
    if (I != J) return pairs[PLACE[I][J]];
    double sum = 0;
    for (int other = 0; other < 4; ++other)
      if (other != I) sum -= pairs[PLACE[I][other]];
    return sum;
  }
};

/// Forces and masses of all parts, over the copies. `topologyChanged` must be called before use and after every cut.
class Assembly {
 public:
  /// `mesh` and `materials` must outlive this. With `warping` false every rotation is the identity.
  Assembly(const CutMesh& mesh, const Materials& materials, Mass mass, Pressure pressure, bool warping, int threads);

  /// Takes over the mesh's parts and copies, of which those round the nodes `touched` have changed; the first call
  /// takes all. New parts get their rotation from the positions `x` [m].
  void topologyChanged(const std::vector<Vec3>& x, const std::vector<int>& touched = {});

  /// R_p of every part from the copies' positions, and from the last R_p by their last digits.
  void rotate(const std::vector<Vec3>& x);
  /// Once more in the same step.
  void rotateOn(const std::vector<Vec3>& x);
  /// Takes `rotate` back, and what rotateOn has done since, when nothing else has been called since but for the forces.
  void rotateBack();
  /// From here on they can be taken back: after one `rotate`, whatever followed it, and after changes of the topology.
  void markRotations() noexcept;
  /// Puts those that there were at the mark in `marked`, without memory from the heap; none without warping. Before
  /// anything else the assembly must be reset.
  void takeMarked(std::vector<Mat3>* marked) noexcept;
  /// R_p of every part; none without warping.
  const std::vector<Mat3>& rotations() const;
  /// Puts those back that there were for the mesh as it is; without any, they stay.
  void recallRotations(const std::vector<Mat3>& rotations);
  /// Forgets what it took over, after the mesh was replaced.
  void reset();

  /// Σ_p w_p R_p K_e (R_pᵀ y − X) [N] at every copy. With y = x it is f_int; as it is affine in y with slope K, one
  /// call at y = x + τ v gives f_int + τ K v.
  void elasticForces(const std::vector<Vec3>& y, std::vector<Vec3>* forces) const;

  /// M w at every copy.
  void multiplyMass(const std::vector<Vec3>& w, std::vector<Vec3>* result) const;

  /// Σ_p V_p ½ σ:ε [J], with the rotations that belong to `x`.
  double elasticEnergy(const std::vector<Vec3>& x) const;

  /// Stress σ [Pa] in the part's own frame, with the rotation that it has, which must be that at `x`.
  Mat3 unrotatedStress(int part, const std::vector<Vec3>& x) const;
  /// Cauchy stress R_p σ R_pᵀ [Pa], with the rotation that belongs to `x`.
  Mat3 stress(int part, const std::vector<Vec3>& x) const;
  /// Cauchy stress [Pa] of every part, with the rotations that belong to `x`. `rotate` at these positions then needs
  /// not find the rotations again.
  void stresses(const std::vector<Vec3>& x, std::vector<Mat3>* stress) const;
  /// Cauchy stress [Pa] of the parts that are `wanted`, and perhaps of some more; what `stress` has of the others is
  /// left.
  void stresses(const std::vector<Vec3>& x, const std::vector<char>& wanted, std::vector<Mat3>* stress) const;
  /// What the principal stresses of every part lie between at `x`: much cheaper than they are, close where the strain
  /// is small, and infinite where it is large or not a number.
  void principalBounds(const std::vector<Vec3>& x, std::vector<PrincipalBounds>* bounds) const;

  /// The tension products of each `wanted` part for Δt² = `factor` [s²], S⁺ being the positive part of its stress with
  /// the rotations that there are, which must be those at `x`; zero for the others.
  void tensionProducts(const std::vector<Vec3>& x, double factor, const std::vector<char>& wanted,
                       std::vector<TensionProducts>* products) const;
  /// The sum over all parts of their tension products times `w`, at every copy.
  void multiplyTension(const std::vector<TensionProducts>& products, const std::vector<Vec3>& w,
                       std::vector<Vec3>* result) const;

  const CutMesh& mesh() const { return mesh_; }
  const Materials& materials() const { return materials_; }
  bool warping() const { return warping_; }
  bool consistentMass() const { return mass_ == Mass::CONSISTENT; }
  int threads() const { return threads_; }
  void setThreads(int threads) { threads_ = threads; }
  /// What shares a dilatation where the pressure is averaged, else null.
  const Patches* patches() const { return patches_ ? &*patches_ : nullptr; }

  /// ρ Σ_p ∫ N_c dX [kg] of every copy: the lumped mass, and the row sums of the consistent one.
  const std::vector<double>& masses() const { return masses_; }
  /// Bound on the rounding of elasticForces at each copy, by the largest coordinate of y [N/m].
  const std::vector<double>& forceRounding() const { return force_rounding_; }
  /// A third of the trace of each copy's block on the diagonal of M [kg] and of K [N/m]; turning changes neither. With
  /// averaged pressure that of K is what it would be without, which is more.
  const std::vector<double>& massDiagonal() const { return consistentMass() ? mass_diagonal_ : masses_; }
  const std::vector<double>& stiffnessDiagonal() const { return stiffness_diagonal_; }
  double volume(int part) const;  ///< V_p [m³]
  /// λ and μ [Pa] of a part's element.
  const Lame& lameOf(int part) const { return elements_[mesh_.parts()[part].element].lame; }
  double patchVolume(int patch) const;               ///< Σ V_p over the parts of a patch [m³]
  Gradients rotatedGradients(int part) const;        ///< g_I = R_p b_I [1/m]
  double massProduct(int part, int I, int J) const;  ///< ρ ∫_p N_I N_J dX [kg]

  /// The corners that use each copy, by ascending part.
  const Lists<Corner>& corners() const { return corners_; }

 private:
  /// All of an element that its forces take.
  struct TissueElement : RestElement {
    Lame lame;
  };

  Mat3 gradientOf(int part, const std::vector<Vec3>& y) const;
  struct StressLanes;
  void findStress(int first, int count, const std::vector<Vec3>& y, StressLanes& lanes) const;
  void addForces(int first, int count, const std::vector<Vec3>& y) const;
  Mat3 rotationAt(int part, const Mat3& F) const;
  int groups() const { return (static_cast<int>(rotations_.size()) + LANES - 1) / LANES; }
  template <typename Function>
  void turnGroup(int group, const std::vector<Vec3>& x, const Function& f) const;
  template <typename Function>
  void turnAll(const std::vector<Vec3>& x, const Function& f) const;
  template <typename Wanted>
  void stressesOfGroups(const std::vector<Vec3>& x, const Wanted& isWanted, std::vector<Mat3>* stress) const;
  void addMeanDilatations(std::vector<PrincipalBounds>* bounds) const;
  void averageDilatations(const std::vector<Vec3>& y) const;
  template <typename Rotation>
  Mat3 stressUnder(int part, const std::vector<Vec3>& x, const Rotation& rotationOf) const;
  template <typename Rotation>
  void averageDilatations(const std::vector<Vec3>& y, const Rotation& rotationOf) const;
  /// σ of a part in its unrotated frame, by λ and μ. With averaged pressure it takes the mean dilatation that was found
  /// last.
  Mat3 stressOf(int part, const Mat3& RtF, const Lame& lame) const {
    return patches_ ? corotatedStress(RtF, mean_dilatations_[patches_->of(part)], lame) : corotatedStress(RtF, lame);
  }
  double densityOf(int part) const { return materials_.of(mesh_.parts()[part].element).density; }
  template <typename Function>
  void gather(const Function& atCorner, std::vector<Vec3>* result) const;
  void findCorners(const std::vector<char>& touched);
  void sumCorners(int copy);

  const CutMesh& mesh_;
  const Materials& materials_;
  Mass mass_;
  bool warping_;
  int threads_;
  std::optional<Patches> patches_;
  std::vector<TissueElement> elements_;
  std::vector<Mat3> rotations_;
  bool rotated_ = false;              // since they were marked, so that found_rotations_ has those,
  std::size_t marked_rotations_ = 0;  // of which there were so many
  std::vector<double> masses_, mass_diagonal_, stiffness_diagonal_, force_rounding_;
  Lists<Corner> corners_;
  mutable std::vector<Mat3> found_rotations_;    // by stresses, at found_at_; else those before the last `rotate`
  mutable std::vector<Vec3> found_at_;           // [m]; empty: nowhere
  mutable RunSums run_sums_;                     // scratch of elasticForces and multiplyTension
  mutable std::vector<char> found_;              // whether those of each group of LANES parts were
  mutable std::vector<Gradients> part_momenta_;  // on all four; scratch of multiplyMass with consistent mass
  mutable std::vector<double> dilatations_, mean_dilatations_;  // of parts and patches; scratch of averaged pressure
  mutable std::vector<double> dilatation_spreads_;  // of parts, likewise: how far they may be off, for bounds alone
};

}  // namespace incision
