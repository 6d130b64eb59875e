// What springs see of the pieces that they act on, and where that lies in the matrix of these.
#include <algorithm>

#include "incision/base/sort_once.h"
#include "rigid_guess_work.h"

namespace incision {

void RigidGuess::Work::findEnds(const RigidPieces& rigid, const std::vector<Vec3>& x,
                                const std::vector<Spring>& springs) {
  number.assign(rigid.pieces(), -1);
  piece.clear();
  ends.clear();
  for (const Spring& spring : springs) {
    for (int k = 0; k < spring.count; ++k) {
      const auto copy = static_cast<std::size_t>(spring.copies[k]);
      if (!rigid.isFree(copy)) continue;
      const int of_copy = rigid.pieceOf(copy);
      int& n = number[static_cast<std::size_t>(of_copy)];
      if (n < 0) {
        n = static_cast<int>(piece.size());
        piece.push_back(of_copy);
      }
      const Span<End> known = ends.unfinished();
      int at = 0;
      while (at < known.size() && known[at].piece != n) ++at;
      if (at == known.size()) ends.append({n, {0, Vec3::Zero()}});
      End& end = ends.unfinished()[at];
      end.seen.a += spring.weights[k];
      end.seen.b += spring.weights[k] * (x[copy] - rigid.centreOf(of_copy));
    }
    ends.finish();
  }
}

/// The lower triangle by columns: blocks on the diagonal, and where a spring lies between two pieces.
void RigidGuess::Work::findPattern() {
  pairs.clear();
  for (std::size_t n = 0; n < piece.size(); ++n) pairs.emplace_back(n, n);
  const auto pairOf = [](const End& a, const End& b) {
    return std::pair(std::min(a.piece, b.piece), std::max(a.piece, b.piece));
  };
  for (int i = 0; i < ends.count(); ++i)
    for (const End& a : std::as_const(ends)[i])
      for (const End& b : std::as_const(ends)[i])
        if (a.piece > b.piece) pairs.push_back(pairOf(a, b));
  sortOnce(&pairs);
  block_of.clear();
  for (int i = 0; i < ends.count(); ++i) {
    const Span<const End> list = std::as_const(ends)[i];
    for (int k = 0; k < list.size(); ++k)
      for (int l = 0; l <= k; ++l)
        block_of.push_back(
            static_cast<int>(std::lower_bound(pairs.begin(), pairs.end(), pairOf(list[k], list[l])) - pairs.begin()));
  }
  findUses();
  blocks.resize(pairs.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [column, row] : pairs)
    for (int j = 0; j < MODES; ++j)
      for (int i = 0; i < MODES; ++i) entries.emplace_back(MODES * row + i, MODES * column + j, 1);
  const auto size = static_cast<int>(MODES * piece.size());
  Equations& fresh = equations.emplace();
  fresh.matrix.resize(size, size);
  fresh.matrix.setFromTriplets(entries.begin(), entries.end());
  fresh.solver.analyzePattern(fresh.matrix);
}

void RigidGuess::Work::findUses() {
  uses.sort(static_cast<int>(pairs.size()), [&](const auto& add) {
    auto block = block_of.begin();
    for (int i = 0; i < ends.count(); ++i) {
      const Span<const End> list = std::as_const(ends)[i];
      for (int k = 0; k < list.size(); ++k)
        for (int l = 0; l <= k; ++l) {
          const bool swapped = list[k].piece < list[l].piece;
          add(*block++, Use{i, swapped ? l : k, swapped ? k : l});
        }
    }
  });
  drives.sort(static_cast<int>(piece.size()), [&](const auto& add) {
    for (int i = 0; i < ends.count(); ++i)
      for (int k = 0; k < std::as_const(ends)[i].size(); ++k) add(std::as_const(ends)[i][k].piece, Use{i, k, k});
  });
}

}  // namespace incision
