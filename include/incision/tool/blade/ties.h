#pragma once

#include <unordered_map>
#include <vector>

#include "incision/cut/section.h"
#include "incision/solver/coupling.h"
#include "incision/tool/blade/sweep.h"

namespace incision {

/// An element's crack is inserted whole when a blade has swept this share of it: with less, what ties the rest would be
/// so stiff that the solver's conditioning suffers, and what is left of the element's own stiffness is no more than
/// this share off.
inline constexpr double FIRST_SHARE = 0.02;

/// What is swept to this share holds no more: its stiffness is below 0.3 % of that of the element.
inline constexpr double LAST_SHARE = 0.95;

/// What holds together the two faces of a stroke's crack in elements that the blade has entered and not left: per area
/// that it has not swept the stiffness κ = κ₀ (1 − s)/s, s being the swept share of the element's section. So nothing
/// jumps when the blade enters or leaves an element: κ is infinite at s = 0 and vanishes at s = 1. It stands for the
/// element's own stiffness across the crack, κ₀ = E/h for an element of size h. Where uncut neighbours still hold its
/// faces together at a node, they cannot open there; so s counts from when the last node that came apart did.
class Ties {
 public:
  /// `young_modulus` [Pa]. Without `progressive` nothing is held.
  Ties(double young_modulus, bool progressive) : young_modulus_(young_modulus), progressive_(progressive) {}

  bool progressive() const { return progressive_; }

  /// A stroke has split these parts and severed these faces; `swept` is its sweep so far in each element.
  template <typename Sweep>
  void add(const Insertion& done, const CutMesh& mesh, const Sweep& swept) {
    area_ += done.severed_area;
    const std::size_t first = ties_.size();
    for (int p : done.parts) addSection(done.crack, p, mesh);
    for (std::size_t t = first; t < ties_.size(); ++t)
      if (const auto found = swept.find(ties_[t].section.element); found != swept.end())
        for (const SweptTriangle& triangle : found->second) mark(triangle, true, &ties_[t]);
    update();
  }

  /// An edge has swept triangles in some elements, on behalf of a crack; −1: none yet.
  void sweep(const std::unordered_map<int, std::vector<SweptTriangle>>& swept, int crack);

  /// After every change of the mesh.
  void topologyChanged(const CutMesh& mesh);

  /// A step starts with the copies at `x` [m].
  void begin(const CutMesh& mesh, const std::vector<Vec3>& x);

  /// Appends what holds in this step.
  void append(std::vector<Coupling>* couplings) const;

  bool empty() const { return ties_.empty(); }

  /// What strokes have cut so far, at rest [m²].
  double area() const { return area_; }

  /// Whether an element has a section that is tied, and if so whether a point near it, carried along its normal, is
  /// where the blade has not been.
  struct Ahead {
    const Section* section = nullptr;
    bool unswept = false;
  };
  Ahead ahead(int element, const Barycentric& point) const;

  /// Joins the pieces of copies that ties hold together; pieces are numbered anew from 0. Returns how many there are.
  int joinPieces(const CutMesh& mesh, std::vector<int>* piece_of) const;

 private:
  struct Tie {
    Section section;                    // its point is the middle of what is not swept
    double area;                        // [m²] at rest
    double steepness;                   // κ₀ [Pa/m]
    double size;                        // h [m]
    Eigen::Vector4d distance;           // from the section's plane, at rest, as weights of the coordinates [m]
    std::vector<Barycentric> left;      // what is not swept of the points that stand for it
    std::size_t count;                  // of all points
    std::array<Barycentric, 3> holds;   // where `left` is held: with its mean and moments
    std::array<Coupling, 3> couplings;  // of the step
    bool changed = true;                // `left`, since `holds` was found
    int apart = 0;                      // nodes at which the two sides have copies of their own,
    double from = 0;                    // and the swept share when the last of them came apart
    double share() const { return 1 - static_cast<double>(left.size()) / static_cast<double>(count); }
  };
  void addSection(int crack, int part, const CutMesh& mesh);
  void mark(const SweptTriangle& triangle, bool own, Tie* tie);
  void update();
  static void hold(Tie* tie);

  double young_modulus_;  // [Pa]
  bool progressive_;
  std::vector<Tie> ties_;
  double area_ = 0;
};

}  // namespace incision
