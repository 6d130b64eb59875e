#include "incision/cut/part.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace incision {
namespace {

Split halve(const Polytope& polytope, const Eigen::Vector4d& phi) {
  const auto halves = split(polytope, phi, cornerSigns(polytope, phi, 0), 0);
  EXPECT_TRUE(halves);
  return *halves;
}

// Σ over the facets of the areas' vectors in (N_1, N_2, N_3): zero for a closed polytope.
Vec3 areaVector(const Polytope& polytope) {
  Vec3 area = Vec3::Zero();
  for (const Facet& facet : polytope.facets) {
    const Vec3 base = polytope.corners[facet.corners[0]].tail<3>();
    for (std::size_t i = 2; i < facet.corners.size(); ++i)
      area += 0.5 * (polytope.corners[facet.corners[i - 1]].tail<3>() - base)
                        .cross(polytope.corners[facet.corners[i]].tail<3>() - base);
  }
  return area;
}

TEST(Part, WholeElementHasTheKnownMoments) {
  const PolytopeMoments m = moments(wholeElement());
  EXPECT_NEAR(m.fraction, 1, 1e-15);
  EXPECT_LT((m.centroid - Barycentric::Constant(0.25)).norm(), 1e-15);
  // ∫ N_I N_J dX / V_e = (1 + δ_IJ) / 20
  const Eigen::Matrix4d known = (Eigen::Matrix4d::Ones() + Eigen::Matrix4d::Identity()) / 20;
  EXPECT_LT((m.products - known).norm(), 1e-15);
}

TEST(Part, TipCutAtHalfTheEdgesIsAnEighth) {
  const Split halves = halve(wholeElement(), {0.5, -0.5, -0.5, -0.5});
  EXPECT_NEAR(moments(halves.positive).fraction, 0.125, 1e-15);
  EXPECT_NEAR(moments(halves.negative).fraction, 0.875, 1e-15);
  EXPECT_EQ(halves.section.size(), 3u);
}

TEST(Part, MomentsOfTheHalvesAddUpHoweverOftenTheyAreSplit) {
  test::Random random(1);
  for (int run = 0; run < 100; ++run) {
    std::vector<Polytope> parts = {wholeElement()};
    for (int k = 0; k < 8; ++k) {
      const Eigen::Vector4d phi(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1),
                                random.uniform(-1, 1));
      std::vector<Polytope> next;
      for (const Polytope& part : parts) {
        const auto signs = cornerSigns(part, phi, 1e-13);
        const auto halves =
            *std::min_element(signs.begin(), signs.end()) < 0 && *std::max_element(signs.begin(), signs.end()) > 0
                ? split(part, phi, signs, k)
                : std::nullopt;
        if (halves) {
          next.push_back(halves->positive);
          next.push_back(halves->negative);
        } else {
          next.push_back(part);
        }
      }
      parts = std::move(next);
    }
    double volume = 0;
    Barycentric first = Barycentric::Zero();
    Eigen::Matrix4d second = Eigen::Matrix4d::Zero();
    for (const Polytope& part : parts) {
      const PolytopeMoments m = moments(part);
      EXPECT_GT(m.fraction, 0);
      EXPECT_LT(areaVector(part).norm(), 1e-14);
      volume += m.fraction;
      first += m.fraction * m.centroid;
      second += m.products;
    }
    EXPECT_NEAR(volume, 1, 1e-13);
    EXPECT_LT((first - Barycentric::Constant(0.25)).norm(), 1e-13);
    EXPECT_LT((second - moments(wholeElement()).products).norm(), 1e-13);
  }
}

TEST(Part, SectionLiesOnTheCrack) {
  test::Random random(2);
  for (int run = 0; run < 200; ++run) {
    const Eigen::Vector4d phi(random.uniform(0.1, 1), random.uniform(-1, 1), random.uniform(-1, 1),
                              random.uniform(-1, -0.1));
    const Split halves = halve(wholeElement(), phi);
    for (const Barycentric& b : halves.section) {
      EXPECT_NEAR(phi.dot(b), 0, 1e-15);
      EXPECT_NEAR(b.sum(), 1, 1e-15);
    }
    EXPECT_GT(phi.dot(moments(halves.positive).centroid), 0);
    EXPECT_LT(phi.dot(moments(halves.negative).centroid), 0);
  }
}

TEST(Part, CornersOnAFaceHaveAnExactZeroThere) {
  test::Random random(3);
  for (int run = 0; run < 200; ++run) {
    const Eigen::Vector4d phi(random.uniform(0.1, 1), random.uniform(-1, 1), random.uniform(-1, 1),
                              random.uniform(-1, -0.1));
    const Split halves = halve(wholeElement(), phi);
    for (const Polytope* half : {&halves.positive, &halves.negative})
      for (const Facet& facet : half->facets)
        if (facet.face >= 0) {
          for (int c : facet.corners) EXPECT_EQ(half->corners[c][facet.face], 0);
        }
  }
}

TEST(Part, CentroidOfAPolygonWithoutAreaIsTheMeanOfItsCorners) {
  const Barycentric a(1, 0, 0, 0), b(0, 1, 0, 0);
  EXPECT_LT((polygonCentroid({a, b, 0.5 * (a + b)}) - 0.5 * (a + b)).norm(), 1e-15);
}

}  // namespace
}  // namespace incision
