#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "incision/base/memory_limits.h"
#include "incision/cut/section.h"
#include "incision/fem/materials.h"
#include "incision/solver/coupler.h"
#include "incision/tool/blade/swept_triangles.h"

namespace incision {

/// An element's crack is inserted whole when a blade has swept this share of it: with less, what ties the rest would be
/// so stiff that the solver's conditioning suffers, and what remains of the element's own stiffness is no more than
/// this share off.
inline constexpr double FIRST_SHARE = 0.02;

/// What is swept to this share is let go: its stiffness is below 0.3 % of that of the element.
inline constexpr double LAST_SHARE = 0.95;

/// A section of a stroke's crack that the blade has entered and not left.
///
///        swept      | unswept
///   ────────────────┼─○──○──○──   the two faces of the crack in one element, with the blade | between;
///   ────────────────┼─○──○──○──   springs at the three points ○ tie what it has not swept
///
struct Tie {
  Section section;                     ///< its point is the middle of what is not swept
  double area;                         ///< [m²] at rest
  double steepness;                    ///< κ₀ [Pa/m]
  double size;                         ///< h [m]
  Eigen::Vector4d distance;            ///< from the section's plane, at rest, as weights of the coordinates [m]
  std::vector<Barycentric> unswept;    ///< of the points that stand for the section
  std::size_t points;                  ///< how many stand for it
  std::array<Barycentric, 3> anchors;  ///< where the springs are: with the mean and moments of `unswept`
  bool moved = true;                   ///< `unswept` has changed since the anchors were found
  int separated = 0;                   ///< nodes at which the two sides have copies of their own,
  double share_then = 0;               ///< and the swept share when the last of them came apart

  /// Counts the nodes at which the two sides have copies of their own. Where one more has come apart, the swept share
  /// counts from now.
  void countSeparated(const CutMesh& mesh);

  /// The share of the section that the blade has swept.
  double share() const { return 1 - static_cast<double>(unswept.size()) / static_cast<double>(points); }
};

template <class Archive>
void serialize(Archive& archive, Tie& tie) {
  auto& [section, area, steepness, size, distance, unswept, points, anchors, moved, separated, share_then] = tie;
  archive(section, area, steepness, size, distance, unswept, points, anchors, moved, separated, share_then);
}

/// What of the ties outlasts a step.
struct TiesMemory {
  std::vector<Tie> ties;
  double area = 0;  ///< that strokes have cut so far, at rest [m²]
};

template <class Archive>
void serialize(Archive& archive, TiesMemory& memory) {
  auto& [ties, area] = memory;
  archive(ties, area);
}

void check(const TiesMemory& memory, const MemoryLimits& limits);

/// What ties together the two faces of strokes' cracks in elements that the blade has entered and not left: per area
/// that it has not swept the stiffness κ = κ₀ (1 − s)/s, s being the swept share of the element's section. So nothing
/// jumps when the blade enters or leaves an element: κ is infinite at s = 0 and vanishes at s = 1. It stands for the
/// element's own stiffness across the crack, κ₀ = E/h for an element of size h. Where uncut neighbours still join its
/// faces at a node, they cannot open there; so s counts from when the last node that came apart did.
class Ties : public WithMemory<Coupler, TiesMemory> {
 public:
  /// `materials` must outlive this.
  explicit Ties(const Materials& materials) : materials_(materials) {}

  /// A stroke has split these parts and severed these faces; `swept` is its sweep so far in each element. Unless it is
  /// `progressive` nothing is tied.
  void add(const Insertion& done, const CutMesh& mesh, const std::unordered_map<int, SweptTriangles>& swept,
           bool progressive) {
    memory_.area += done.severed_area;
    const std::size_t first = memory_.ties.size();
    for (int p : done.parts) addSection(done.crack, p, mesh, progressive);
    for (std::size_t t = first; t < memory_.ties.size(); ++t)
      if (const auto found = swept.find(memory_.ties[t].section.element); found != swept.end())
        mark(found->second.all(), true, &memory_.ties[t]);
    for (std::size_t t = first; t < memory_.ties.size(); ++t) memory_.ties[t].countSeparated(mesh);
    finishSweep();
  }

  /// An edge has swept triangles in some elements, on behalf of a crack where there is one yet.
  void sweep(const std::unordered_map<int, std::vector<SweptTriangle>>& swept, std::optional<int> crack);

  void changed(const CutMesh& mesh) override;
  bool begin(const StepStart& start, std::vector<Spring>* springs) override;
  void update(Span<const Vec3> /*moved*/, Span<Spring> /*springs*/) override {}  // they are linear
  void accept(const StepSpan& /*span*/, Span<const Vec3> /*moved*/, const Motion& /*end*/,
              const Wrench& /*felt*/) override {}
  void joinPieces(const CutMesh& mesh, const std::vector<int>& piece, DisjointSets* sets) const override;

  /// What strokes have cut so far, at rest [m²].
  double area() const { return memory_.area; }

  /// Whether an element has a section that is tied, and if so whether a point near it, carried along its normal, is
  /// where the blade has not been.
  struct Ahead {
    const Section* section = nullptr;
    bool unswept = false;
  };
  Ahead ahead(int element, const Barycentric& point) const;

 private:
  void addSection(int crack, int part, const CutMesh& mesh, bool progressive);
  void mark(Span<const SweptTriangle> triangles, bool own_crack, Tie* tie);
  void finishSweep();

  const Materials& materials_;
};

}  // namespace incision
