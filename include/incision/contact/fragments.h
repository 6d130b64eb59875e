#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "incision/base/lists.h"
#include "incision/contact/candidate.h"
#include "incision/contact/contact_surface.h"

namespace incision {

/// Finds where the body may touch itself: its samples against its triangles, pieces against pieces and a piece against
/// itself. Time and memory are linear in the surface.
class FragmentFinder {
 public:
  /// A sample and the triangle before it, nearest by |gap|.
  struct Pair {
    int sample, triangle;
    double gap;
    Vec3 weights;  ///< of the triangle's corners at the foot of the sample
  };

  /// What outlasts a step: the last search, which serves until something has moved too far.
  struct Memory {
    std::vector<Vec3> x;     ///< where the vertices were [m]; empty: there is none
    std::vector<Pair> best;  ///< of each sample; triangle −1: none
  };
  const Memory& keep() const { return memory_; }
  /// Puts a memory back that was kept of the same surface.
  void recall(const Memory& memory) { memory_ = memory; }

  /// Before the first search and whenever the surface changes.
  void surfaceChanged();

  /// The step for which `find` was called last has failed.
  void stepFailed();

  /// Candidates for a step from positions `x` [m] of the surface's vertices, which go by `ahead` [m] if nothing new
  /// acts, appended in the order of the samples, at most one for each. A sample has a candidate where it lies before or
  /// just behind a triangle that faces it, and where the two could meet within the step.
  ///
  /// What lay behind a triangle of its own piece at rest has material in between, and is none.
  void find(const ContactSurface& surface, const std::vector<Vec3>& x, const std::vector<Vec3>& ahead, int threads,
            std::vector<Candidate>* candidates);

 private:
  using Cell = Eigen::Array<std::int64_t, 3, 1>;

  void measure(const ContactSurface& surface, const std::vector<Vec3>& x, int threads);
  bool isFresh(const ContactSurface& surface, const std::vector<Vec3>& x, const std::vector<Vec3>& ahead) const;
  void search(const ContactSurface& surface, const std::vector<Vec3>& x, const std::vector<Vec3>& ahead, int threads);
  void fillGrid(const ContactSurface& surface, const std::vector<Vec3>& x);
  template <typename Function>
  bool forEachSlot(const Eigen::AlignedBox3d& box, const Function& f) const;
  Eigen::AlignedBox3d pathOf(const std::vector<Vec3>& x, int vertex) const;
  void pairTriangle(const ContactSurface& surface, const std::vector<Vec3>& x, int triangle,
                    std::vector<Pair>* pairs) const;
  bool meets(const ContactSurface& surface, const std::vector<Vec3>& x, int triangle, int sample, Pair* pair) const;
  Pair placed(const ContactSurface& surface, const std::vector<Vec3>& x, const Pair& pair) const;
  static Spring between(const ContactSurface& surface, const Pair& pair);
  int twinOf(const ContactSurface& surface, const Pair& pair) const;
  Candidate candidate(const ContactSurface& surface, const Pair& pair, double share) const;
  Cell cellOf(const Vec3& point) const;
  int slotOf(const Cell& cell) const;

  Memory memory_, before_;  // `before_`: until the search of this step,
  bool searched_ = false;   // where there was one
  double cell_ = 0, reach_ = 0;
  std::vector<Vec3> paths_;               // what each moves in a step, beside the mean [m]
  std::vector<Vec3> areas_;               // of each triangle: its normal, twice its area long
  std::vector<Vec3> normals_;             // of each triangle, unit or zero
  std::vector<Vec3> sample_normals_;      // of each sample, unit or zero
  std::size_t slots_ = 1;                 // of the grid, a power of two: a slot is for many cells
  Lists<int> samples_in_;                 // each slot
  std::vector<std::vector<Pair>> found_;  // by chunk of triangles
};

template <class Archive>
void serialize(Archive& archive, FragmentFinder::Pair& pair) {
  auto& [sample, triangle, gap, weights] = pair;
  archive(sample, triangle, gap, weights);
}

template <class Archive>
void serialize(Archive& archive, FragmentFinder::Memory& memory) {
  auto& [x, best] = memory;
  archive(x, best);
}

}  // namespace incision
