#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "incision/contact/contact_surface.h"
#include "incision/contact/fresh_things.h"
#include "incision/contact/pair_search.h"
#include "incision/contact/piece_frames.h"
#include "incision/contact/piece_trees.h"
#include "incision/contact/surface_match.h"

namespace incision {

/// Which samples may meet which triangles, being above or below them, and which edges, of two pieces, or of one and
/// itself, in a step. What was found stays as long as the two have moved relative to each other by less than the search
/// looked beyond its reach: it holds all that is within reach, and more, so that it makes no difference when the search
/// was.
class NearPairs {
 public:
  struct Pair {
    int a, b;                                ///< pieces, a ≤ b
    std::vector<std::pair<int, int>> edges;  ///< of a and of b

    /// By sample, then by triangle.
    const std::vector<SampleTriangle>& faces() const { return is_narrow ? nearest : near; }

   private:
    friend class NearPairs;
    void sort();
    std::vector<SampleTriangle> near;     // all that a search has found, and
    std::vector<SampleTriangle> nearest;  // of those, what a narrower search leaves
    PairSearch search, narrow;            // which these were
    double size = 0;                      // the larger one of the two [m],
    double reach = 0;                     // and its reach [m],
    Reach searched = {0, 0};              // and so how far in all
    bool is_searched = false;             // to the end
    bool is_incomplete = false;           // it lacks what is fresh
    bool is_narrow = false;               // the narrower search was made since
  };

  /// The surface is another one, with its vertices at `x` [m]. What pieces that are still there had near each other
  /// stays, and of them only what is fresh is looked for, as long as that is little.
  void surfaceChanged(const ContactSurface& surface, const std::vector<Vec3>& x);

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

  /// How many pairs have been searched since this was made, but for what was fresh alone.
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

  using Pairs = std::vector<std::vector<std::unique_ptr<Pair>>>;  // of each piece, those with later ones

  Pairs kept(Pairs* before, const SurfaceMatch& known) const;
  void renumber(const SurfaceMatch& known, Pair* pair) const;
  void addFresh(const ContactSurface& surface, const std::vector<Vec3>& x, int threads);
  void startSearch(double reach, std::size_t stale);
  void narrowAll(const ContactSurface& surface, const std::vector<Vec3>& x, const std::vector<Vec3>& ahead,
                 int threads);
  void narrow(const ContactSurface& surface, const std::vector<Vec3>& x, Pair* pair) const;
  void searchShares(const ContactSurface& surface, const std::vector<Vec3>& x, int threads);

  SurfaceOutline outline_;
  PieceFrames frames_;
  PieceFrames close_frames_;  // for narrower searches: with shapes that are never far off
  FreshThings fresh_;
  PieceTrees trees_;
  bool has_trees_ = false;                      // of the surface there is
  double base_margin_ = 0, margin_of_one_ = 0;  // of two pieces, and of a piece with itself [m]
  double narrow_margin_ = 0;                    // of what is searched again in what was found [m]
  int searches_ = 0;
  Pairs pairs_;
  std::vector<std::pair<double, int>> sweep_;  // pieces by where they begin along x
  std::vector<std::pair<int, int>> close_;
  std::vector<Pair*> active_, stale_, incomplete_;
  std::vector<int> to_place_;
  std::vector<char> placed_;  // in this step, of each piece
  std::vector<Share> shares_;
};

}  // namespace incision
