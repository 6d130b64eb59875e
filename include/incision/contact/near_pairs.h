#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "incision/contact/contact_surface.h"
#include "incision/contact/piece_frames.h"
#include "incision/contact/piece_trees.h"

namespace incision {

/// Which samples may meet which triangles, being above or below them, and which edges, of two pieces, or of one and
/// itself, in a step. What was found stays as long as the two have moved relative to each other by less than the search
/// looked beyond its reach: it holds all that is within reach, and more, so that it makes no difference when the search
/// was.
class NearPairs {
 public:
  struct SampleTriangle {
    int sample, triangle;
  };
  struct Pair {
    int a, b;                                ///< pieces, a ≤ b
    std::vector<SampleTriangle> faces;       ///< by sample, then by triangle
    std::vector<std::pair<int, int>> edges;  ///< of a and of b

   private:
    friend class NearPairs;
    PieceFrames::Frame from_a, from_b;  // where they were at the search
    double worn = 0;                    // of both at the search [m]
    double off = 0;                     // of both from their shapes at the search [m]
    double margin = 0;                  // by how much it looked further than to its reach, [m]
    double further = 0;                 // and so how far in all [m]
    double aside = 0;                   // and how far from above a triangle, within its plane [m]
  };

  void surfaceChanged(const ContactSurface& surface);

  /// `reach`: how near two things must come in the step to count, in elements.
  void update(const ContactSurface& surface, const std::vector<Vec3>& x, const std::vector<Vec3>& ahead, double reach,
              int threads);

  /// Those of the step, by their pieces.
  const std::vector<Pair*>& active() const { return active_; }

  /// The trees, after these pieces, ascending, have been placed at the positions of the step.
  const PieceTrees& placeTrees(const ContactSurface& surface, const std::vector<Vec3>& x,
                               const std::vector<int>& pieces, int threads);

  /// The trees, after these pieces, ascending, have been placed at other positions of the vertices than those of the
  /// step [m]: placeTrees then places again what it is asked for.
  const PieceTrees& placeTreesElsewhere(const ContactSurface& surface, const std::vector<Vec3>& x,
                                        const std::vector<int>& pieces, int threads);

  /// How many pairs have been searched since the surface changed.
  int searches() const { return searches_; }

 private:
  void findClosePieces(double reach);
  /// A part of a search, and what it has found.
  struct Share {
    std::size_t stale;  // index of the pair
    PieceTrees::Share nodes;
    std::vector<SampleTriangle> faces;
    std::vector<std::pair<int, int>> edges;
  };

  double needed(const Pair& pair) const;
  void startSearch(double reach, std::size_t stale);
  void searchShares(const ContactSurface& surface, const std::vector<Vec3>& x, int threads);
  void addClose(const ContactSurface& surface, const std::vector<Vec3>& x, const Pair& pair, int t, int other,
                std::vector<SampleTriangle>* faces) const;

  PieceFrames frames_;
  PieceTrees trees_;
  Lists<int> samples_of_, edges_of_;            // each triangle: those that it stands for
  std::vector<char> has_area_;                  // of each triangle
  double base_margin_ = 0, margin_of_one_ = 0;  // of two pieces, and of a piece with itself [m]
  int searches_ = 0;
  std::vector<std::vector<std::unique_ptr<Pair>>> pairs_;  // of each piece, those with later ones
  std::vector<std::pair<double, int>> sweep_;              // pieces by where they begin along x
  std::vector<std::pair<int, int>> close_;
  std::vector<Pair*> active_, stale_;
  std::vector<int> to_place_;
  std::vector<char> placed_;  // in this step, of each piece
  std::vector<Share> shares_;
};

}  // namespace incision
