// The displacements that the parts of an element can take against those of the paper's equation 6.
#include <gtest/gtest.h>

#include <Eigen/QR>

#include "support/cut_laws.h"
#include "support/deformed_mesh.h"
#include "support/scenes.h"

namespace incision {
namespace {

using test::DeformedMesh;

double heaviside(double f) { return f >= 0 ? 1 : 0; }

// N_I restricted to the parts that use one copy, for each copy in the element.
Eigen::MatrixXd copyFunctions(const CutMesh& mesh, int element, const std::vector<Barycentric>& points) {
  std::map<int, int> column;
  for (int p = element; p >= 0; p = mesh.parts()[p].next)
    for (int copy : mesh.parts()[p].copies) column.try_emplace(copy, static_cast<int>(column.size()));
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(static_cast<long>(points.size()), static_cast<long>(column.size()));
  for (std::size_t k = 0; k < points.size(); ++k) {
    const int p = test::partAt(mesh, element, points[k]);
    for (int I = 0; I < 4; ++I) values(static_cast<long>(k), column[mesh.parts()[p].copies[I]]) = points[k][I];
  }
  return values;
}

// N_I, N_I φ_cI and N_I (H(f_C) − H(f_C,I)). The later crack c lies on the positive side of C: A1 is the other side.
Eigen::MatrixXd paperFunctions(const Eigen::Vector4d& f_C, const Eigen::Vector4d& f_c,
                               const std::vector<Barycentric>& points) {
  Eigen::MatrixXd values(static_cast<long>(points.size()), 12);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double C = f_C.dot(points[k]), c = f_c.dot(points[k]);
    for (int I = 0; I < 4; ++I) {
      const double jump_C = heaviside(C) - heaviside(f_C[I]), jump_c = heaviside(c) - heaviside(f_c[I]);
      const double N = points[k][I];
      values.block<1, 3>(static_cast<long>(k), 3 * I) << N, N * (C < 0 ? jump_C : jump_c), N * jump_C;
    }
  }
  return values;
}

long rank(const Eigen::MatrixXd& functions) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(functions);
  qr.setThreshold(1e-9);
  return qr.rank();
}

std::vector<Barycentric> pointsOf(const CutMesh& mesh, int element, test::Random* random) {
  std::vector<Barycentric> points;
  for (int p = element; p >= 0; p = mesh.parts()[p].next)
    for (int k = 0; k < 8; ++k) {
      // Within the part: a mean of its corners.
      Barycentric point = Barycentric::Zero();
      double sum = 0;
      for (const Barycentric& corner : mesh.polytope(p).corners) {
        const double weight = random->uniform(0.05, 1);
        point += weight * corner;
        sum += weight;
      }
      points.push_back(point / sum);
    }
  return points;
}

TEST(PaperSpace, OfTwoCracksInAnElementIsThatOfItsParts) {
  test::Random random(50);
  const GridSettings box = {{3, 3, 3}, Vec3::Ones(), Vec3::Zero()};
  int compared = 0, of_two_parts = 0;
  for (int run = 0; run < 40; ++run) {
    DeformedMesh body(test::jitteredGrid(box, 0.15, &random));
    const PlaneCut C = random.plane(box), c = random.plane(box);
    const CrackField first = planeField(C, body.mesh, body.x);
    body.mesh.insert(first);
    body.follow();
    // The later crack is stopped by the former: it cuts only what lies on its positive side.
    CrackField second = planeField(c, body.mesh, body.x);
    for (int p = 0; p < static_cast<int>(body.mesh.parts().size()); ++p) {
      const Part& part = body.mesh.parts()[p];
      double at = 0;
      for (int I = 0; I < 4; ++I)
        at += body.mesh.centroid(p)[I] * first.phi[body.mesh.mesh().elements[part.element][I]];
      if (at > 0) second.parts.push_back(p);
    }
    body.mesh.insert(second);
    body.follow();

    for (int e = 0; e < static_cast<int>(body.mesh.mesh().elements.size()); ++e) {
      Eigen::Vector4d f_C, f_c;
      for (int I = 0; I < 4; ++I) {
        f_C[I] = first.phi[body.mesh.mesh().elements[e][I]];
        f_c[I] = second.phi[body.mesh.mesh().elements[e][I]];
      }
      int parts = 0;
      double least = 1;
      for (int p = e; p >= 0; p = body.mesh.parts()[p].next, ++parts)
        least = std::min(least, body.mesh.parts()[p].fraction);
      // Slivers leave too few digits to tell a rank.
      if (parts < 2 || f_C.minCoeff() >= 0 || f_C.maxCoeff() <= 0 || f_c.cwiseProduct(f_C).isZero() || least < 1e-4)
        continue;
      const std::vector<Barycentric> points = pointsOf(body.mesh, e, &random);
      const Eigen::MatrixXd ours = copyFunctions(body.mesh, e, points), theirs = paperFunctions(f_C, f_c, points);
      Eigen::MatrixXd both(ours.rows(), ours.cols() + theirs.cols());
      both << ours, theirs;
      EXPECT_EQ(rank(ours), 4 * parts);
      EXPECT_EQ(rank(theirs), 4 * parts);
      EXPECT_EQ(rank(both), 4 * parts);
      ++(parts == 3 ? compared : of_two_parts);
    }
  }
  EXPECT_GT(compared, 100);
  EXPECT_GT(of_two_parts, 100);
}

}  // namespace
}  // namespace incision
