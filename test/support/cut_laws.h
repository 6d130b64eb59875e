#pragma once

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>

#include "incision/cut/cut_mesh.h"
#include "support/random.h"

namespace incision::test {

/// Sets that are joined step by step.
class Sets {
 public:
  explicit Sets(std::size_t count) : link_(count) { std::iota(link_.begin(), link_.end(), 0); }
  int find(int i) {
    while (link_[i] != i) i = link_[i] = link_[link_[i]];
    return i;
  }
  void join(int a, int b) { link_[find(a)] = find(b); }

 private:
  std::vector<int> link_;
};

inline int localNode(const CutMesh& mesh, int element, int node) {
  const auto& nodes = mesh.mesh().elements[element];
  return static_cast<int>(std::find(nodes.begin(), nodes.end(), node) - nodes.begin());
}

/// Calls f(pair, face) for what overlaps on each inner face, once.
template <typename Function>
void forFacePairs(const CutMesh& mesh, const Function& f) {
  for (int e = 0; e < static_cast<int>(mesh.mesh().elements.size()); ++e)
    for (int face = 0; face < 4; ++face)
      if (mesh.topology().neighbours[e][face] > e)
        for (const FacePair& pair : mesh.facePairs(e, face)) f(pair, face);
}

/// Parts fill their elements and have material, and overlaps fill the faces.
inline void expectPartsFillTheMesh(const CutMesh& mesh) {
  std::vector<double> filled(mesh.mesh().elements.size(), 0);
  for (const Part& part : mesh.parts()) {
    EXPECT_GT(part.fraction, 0);
    filled[part.element] += part.fraction;
  }
  for (double sum : filled) EXPECT_NEAR(sum, 1, 1e-12);

  std::map<std::pair<int, int>, double> covered;
  forFacePairs(mesh, [&](const FacePair& pair, int face) {
    covered[{mesh.parts()[pair.part].element, face}] += faceShare(pair.polygon);
  });
  // Overlaps of MIN_OVERLAP and less are left out.
  for (const auto& [face, share] : covered) EXPECT_NEAR(share, 1, 1e-10);
}

/// Copies are exactly the sets of corners that hang together round a node; each has parts, and each node an own copy.
inline void expectCopiesAreComponents(const CutMesh& mesh) {
  Sets corners(4 * mesh.parts().size());
  forFacePairs(mesh, [&](const FacePair& pair, int face) {
    if (pair.severed_by) return;
    const Part &p = mesh.parts()[pair.part], &q = mesh.parts()[pair.other];
    for (int I : FACE_NODES[face]) {
      const int J = localNode(mesh, q.element, mesh.mesh().elements[p.element][I]);
      corners.join(4 * pair.part + I, 4 * pair.other + J);
    }
  });
  std::map<int, int> copy_of;
  std::set<int> used;
  for (int p = 0; p < static_cast<int>(mesh.parts().size()); ++p)
    for (int I = 0; I < 4; ++I) {
      const Part& part = mesh.parts()[p];
      const int copy = part.copies[I];
      used.insert(copy);
      EXPECT_EQ(mesh.copyNode(copy), mesh.mesh().elements[part.element][I]);
      EXPECT_EQ(copy_of.try_emplace(corners.find(4 * p + I), copy).first->second, copy) << "one set, two copies";
    }
  EXPECT_EQ(copy_of.size(), used.size()) << "two sets share a copy";
  EXPECT_EQ(static_cast<int>(used.size()), mesh.numCopies()) << "copies without parts";
}

/// Every own copy is one of a part that holds the node.
inline void expectOwnCopiesHoldTheirNodes(const CutMesh& mesh) {
  std::set<int> holding;
  for (int p = 0; p < static_cast<int>(mesh.parts().size()); ++p)
    for (int I = 0; I < 4; ++I)
      if (mesh.holdsNode(p, I)) holding.insert(mesh.parts()[p].copies[I]);
  for (int n = 0; n < static_cast<int>(mesh.mesh().nodes.size()); ++n) EXPECT_TRUE(holding.count(mesh.ownCopy(n)));
}

/// Pieces told by copies are what a walk from part to part through faces finds.
inline void expectPiecesAreWhatHangsTogether(const CutMesh& mesh) {
  Sets parts(mesh.parts().size());
  forFacePairs(mesh, [&](const FacePair& pair, int) {
    if (!pair.severed_by) parts.join(pair.part, pair.other);
  });
  int count = 0;
  const std::vector<int> piece = mesh.copyPieces(&count);
  std::map<int, int> piece_of;
  for (int p = 0; p < static_cast<int>(mesh.parts().size()); ++p)
    for (int copy : mesh.parts()[p].copies)
      EXPECT_EQ(piece_of.try_emplace(parts.find(p), piece[copy]).first->second, piece[copy]);
  EXPECT_EQ(static_cast<int>(piece_of.size()), count);
}

/// The part that holds a point of an element, or −1 when rounding could decide. With `face` ≥ 0 the point lies there.
inline int partAt(const CutMesh& mesh, int element, const Barycentric& point, int face = -1) {
  constexpr double CLEAR = 1e-9;
  for (int p = element; p >= 0; p = mesh.parts()[p].next) {
    const Polytope& polytope = mesh.polytope(p);
    if (face >= 0 && !polytope.onFace(face)) continue;
    double depth = 1;
    for (const Facet& facet : polytope.facets) {
      if (face >= 0 && facet.face == face) continue;
      const Vec3 base = polytope.corners[facet.corners[0]].tail<3>();
      Vec3 normal = Vec3::Zero();
      for (std::size_t i = 2; i < facet.corners.size(); ++i)
        normal += (polytope.corners[facet.corners[i - 1]].tail<3>() - base)
                      .cross(polytope.corners[facet.corners[i]].tail<3>() - base);
      depth = std::min(depth, -normal.stableNormalized().dot(point.tail<3>() - base));
    }
    if (depth > CLEAR) return p;
  }
  return -1;
}

/// Draws points on inner faces: the parts that meet there share the face's copies unless a crack severs them.
inline void expectContinuityAtRandomFacePoints(const CutMesh& mesh, int points, Random* random) {
  for (int k = 0; k < points; ++k) {
    const int e = random->index(static_cast<int>(mesh.mesh().elements.size())), face = random->index(4);
    const int across = mesh.topology().neighbours[e][face];
    if (across < 0) continue;
    Barycentric here = random->inElement(), there = Barycentric::Zero();
    here[face] = 0;
    here /= here.sum();
    int back = 6;  // the local nodes of a face and the one opposite sum to 6
    for (int I : FACE_NODES[face]) {
      const int J = localNode(mesh, across, mesh.mesh().elements[e][I]);
      there[J] = here[I];
      back -= J;
    }
    const int p = partAt(mesh, e, here, face), q = partAt(mesh, across, there, back);
    if (p < 0 || q < 0) continue;
    const std::vector<FacePair> pairs = mesh.facePairs(e, face);
    const auto pair =
        std::find_if(pairs.begin(), pairs.end(), [&](const FacePair& c) { return c.part == p && c.other == q; });
    ASSERT_NE(pair, pairs.end()) << "parts meet at a point but do not overlap";
    if (pair->severed_by) continue;
    for (int I : FACE_NODES[face]) {
      const int J = localNode(mesh, across, mesh.mesh().elements[e][I]);
      EXPECT_EQ(mesh.parts()[p].copies[I], mesh.parts()[q].copies[J]);
    }
  }
}

/// All of these laws.
inline void expectSoundCutMesh(const CutMesh& mesh) {
  expectPartsFillTheMesh(mesh);
  expectCopiesAreComponents(mesh);
  expectOwnCopiesHoldTheirNodes(mesh);
  expectPiecesAreWhatHangsTogether(mesh);
}

}  // namespace incision::test
