#pragma once

#include "incision/cut/cut_mesh.h"
#include "support/random.h"

namespace incision::test {

/// A cut mesh and where its copies stand.
struct DeformedMesh {
  explicit DeformedMesh(TetMesh rest) : mesh(std::move(rest)) { follow(); }

  /// New copies start where their parent is.
  void follow() {
    for (int c = static_cast<int>(x.size()); c < mesh.numCopies(); ++c)
      x.push_back(mesh.copyParent(c) == c ? mesh.mesh().nodes[mesh.copyNode(c)] : x[mesh.copyParent(c)]);
  }

  Insertion cut(const PlaneCut& plane) {
    const Insertion done = mesh.insert(planeField(plane, mesh, x));
    follow();
    return done;
  }

  /// Cuts with φ given at the nodes; every copy of a node takes the same.
  Insertion cut(const std::vector<double>& node_phi, const std::vector<int>& parts = {}) {
    CrackField field;
    for (int c = 0; c < mesh.numCopies(); ++c) field.phi.push_back(node_phi[mesh.copyNode(c)]);
    field.parts = parts;
    const Insertion done = mesh.insert(field);
    follow();
    return done;
  }

  /// Turns and moves each piece by itself.
  void scatter(double distance, Random* random) {
    int count = 0;
    const std::vector<int> piece = mesh.copyPieces(&count);
    for (int k = 0; k < count; ++k) {
      const Mat3 R = random->rotation();
      const Vec3 shift = random->vector(distance);
      for (int c = 0; c < mesh.numCopies(); ++c)
        if (piece[c] == k) x[c] = R * x[c] + shift;
    }
  }

  /// Moves every copy by itself.
  void shake(double distance, Random* random) {
    for (Vec3& copy : x) copy += random->vector(distance);
  }

  int pieces() const {
    int count = 0;
    mesh.copyPieces(&count);
    return count;
  }

  CutMesh mesh;
  std::vector<Vec3> x;
};

}  // namespace incision::test
