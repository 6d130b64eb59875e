#pragma once

#include <vector>

#include "incision/contact/candidate.h"
#include "incision/contact/edge_meeting.h"
#include "incision/contact/face_meeting.h"
#include "incision/contact/near_pairs.h"
#include "incision/contact/step_end.h"

namespace incision {

/// Finds where the body may touch itself: its samples against its triangles, pieces against pieces and a piece against
/// itself, and edges of pieces against edges of others. Time and memory are linear in the surface. What it finds
/// depends on the step alone, not on the steps before.
class FragmentFinder {
 public:
  /// Before the first step and whenever the surface changes.
  void surfaceChanged() { changed_ = true; }

  /// Candidates for a step from positions `x` [m] of the surface's vertices, which go by `ahead` [m] if nothing new
  /// acts, appended in their order: edges, then samples, at most one for each sample and piece. A sample has a
  /// candidate where it lies before or just behind a triangle that faces it, and where the two could meet within the
  /// step. `touches`, the contacts of the last step, tell on which side of something thin a sample has been.
  ///
  /// What lay behind a triangle of its own piece at rest has material in between, and is none.
  void find(const ContactSurface& surface, const std::vector<Vec3>& x, const std::vector<Vec3>& ahead,
            const std::vector<Touch>& touches, int threads, std::vector<Candidate>* candidates);

  const NearPairs& pairs() const { return pairs_; }

  /// Where the step from there ends: StepEnd::isAsReckoned.
  bool isAsReckoned(const ContactSurface& surface, const std::vector<Candidate>& candidates, Span<const Vec3> moved,
                    double share, const std::vector<Vec3>& x, int threads) {
    return step_end_.isAsReckoned(surface, candidates, moved, share, x, &pairs_, threads);
  }

 private:
  /// A sample and where it meets a piece.
  struct Found : FaceMeeting {
    int piece;
  };

  /// Some of the faces of a pair, with all of each of their samples, and what they meet.
  struct Share {
    const SampleTriangle *first, *last;
    bool of_one_piece;
    std::vector<Found> found;
    std::vector<Span<const SampleTriangle>> deep;  ///< samples with what is near them, to be looked at twice
  };

  void measure(const ContactSurface& surface, const std::vector<Vec3>& x, const std::vector<Vec3>& ahead, int threads);
  void divideFaces();
  void findFaces(const SkinInStep& skin, const std::vector<Touch>& touches, Share* share) const;
  void findDeepFaces(const SkinInStep& skin, const std::vector<Touch>& touches, int threads);
  void findEdges(const SkinInStep& skin, const std::vector<Touch>& touches, const NearPairs::Pair& pair,
                 std::vector<EdgeMeeting>* found) const;
  void gather();
  int twinOf(const ContactSurface& surface, const Found& found) const;

  bool changed_ = true;
  NearPairs pairs_;
  StepEnd step_end_;
  std::vector<Vec3> normals_, end_normals_;         // of each triangle, unit or zero
  std::vector<Vec3> sample_normals_;                // of each sample, unit or zero
  std::vector<Share> shares_;                       // of all pairs, one after the other,
  int shares_used_ = 0;                             // and how many there are in this step
  std::vector<std::vector<EdgeMeeting>> edges_in_;  // by pair
  std::vector<Found> faces_;                        // by sample, then by piece
  std::vector<EdgeMeeting> edges_;                  // by the one edge, then by the other
  std::vector<int> deep_in_;                        // pieces that samples are deep in
};

}  // namespace incision
