#include "incision/contact/fragments.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numeric>

#include "support/rig.h"

namespace incision {
namespace {

// A block as contact sees it.
struct Touching : Rig {
  Touching(const std::array<int, 3>& cells, const Vec3& size) : Rig(block(cells, size), {}) {}

  // After the cuts.
  std::vector<Candidate> find() {
    surface = buildSurface(mesh);
    contact = makeContactSurface(surface, mesh, materials, step.pieceOf());
    contact.young_modulus.assign(surface.vertices.size(), 1 / CONTACT_STIFFNESS);
    x = surfacePositions(surface, motion.x);
    v = surfacePositions(surface, motion.v);
    finder.surfaceChanged();
    return again();
  }
  // Once more, with positions that have changed since.
  std::vector<Candidate> again() {
    x = surfacePositions(surface, motion.x);
    std::vector<Candidate> candidates;
    ahead.resize(v.size());
    for (std::size_t i = 0; i < v.size(); ++i) ahead[i] = 0.01 * v[i];
    finder.find(contact, x, ahead, 1, &candidates);
    return candidates;
  }
  // Moves a piece as a rigid one.
  void move(int piece, const Vec3& by, double turn = 0) {
    const Mat3 R = Eigen::AngleAxisd(turn, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (std::size_t c = 0; c < motion.x.size(); ++c)
      if (step.pieceOf()[c] == piece) motion.x[c] = R * motion.x[c] + by;
  }

  Surface surface;
  ContactSurface contact;
  FragmentFinder finder;
  std::vector<Vec3> x, v, ahead;
};

TEST(ContactSurface, GivesASampleToEachSideOfAnEdge) {
  Touching rig({2, 2, 2}, Vec3::Ones());
  rig.find();
  double area = 0;
  std::vector<int> sides(4, 0);
  for (const auto& sample : rig.contact.samples) area += sample.area;
  for (std::size_t v = 0; v < rig.x.size(); ++v) ++sides[rig.contact.sample_start[v + 1] - rig.contact.sample_start[v]];
  EXPECT_NEAR(area, 6, 1e-12);
  EXPECT_EQ(sides, (std::vector<int>{0, 6, 12, 8}));  // inside faces, on edges, at corners
  EXPECT_NEAR(rig.contact.mean_size, 0.5, 1e-12);
}

TEST(FragmentFinder, FindsNothingInABodyThatIsWhole) {
  for (const std::array<int, 3>& cells : {std::array<int, 3>{4, 4, 4}, {8, 8, 1}, {1, 1, 16}}) {
    Touching rig(cells, 0.1 * Vec3(cells[0], cells[1], cells[2]));
    EXPECT_TRUE(rig.find().empty());
    for (Vec3& x : rig.motion.x) x = Vec3(x.x() + 0.3 * std::sin(x.z()), x.y(), 0.7 * x.z());  // squeezed and bent
    EXPECT_TRUE(rig.again().empty());
  }
}

// As those that close gaps of the surface, whose corners may belong to any parts.
TEST(FragmentFinder, TakesNoTriangleWithoutAreaAtRest) {
  Touching rig({2, 2, 2}, Vec3::Ones());
  rig.cut(plane(Vec3(0.5, 0.5, 0.45), Vec3::UnitZ()));
  EXPECT_FALSE(rig.find().empty());
  for (Vec3& X : rig.contact.rest) X = Vec3(0.5, 0.5, X.z());
  rig.finder.surfaceChanged();
  EXPECT_TRUE(rig.again().empty());
}

// Every point of one face lies on the other, with no gap; twins are one contact.
TEST(FragmentFinder, FindsFacesJustCutTouchingAndNoMore) {
  Touching rig({4, 4, 4}, Vec3::Ones());
  ASSERT_TRUE(rig.cut(plane(Vec3(0.5, 0.5, 0.55), Vec3(0.2, 0.1, 1))).changed());
  const std::vector<Candidate> found = rig.find();
  int on_cuts = 0;
  for (const auto& sample : rig.contact.samples) on_cuts += rig.surface.cut_face[rig.contact.around[sample.first]];
  EXPECT_EQ(2 * static_cast<int>(found.size()), on_cuts);
  double stiffness = 0;
  for (const Candidate& candidate : found) {
    EXPECT_LT(std::abs(candidate.gap), 1e-12);
    EXPECT_TRUE(rig.surface.cut_face[rig.contact.around[rig.contact.samples[candidate.sample].first]]);
    EXPECT_NEAR(
        std::accumulate(candidate.point.weights.begin(), candidate.point.weights.begin() + candidate.point.count, 0.0),
        0, 1e-12);
    stiffness += candidate.stiffness * candidate.size;
  }
  double area = 0;
  for (const auto& sample : rig.contact.samples)
    if (rig.surface.cut_face[rig.contact.around[sample.first]]) area += sample.area / 2;
  EXPECT_NEAR(stiffness, area, 1e-9 * area);
}

// The nearest triangle for each sample by trying all, without a grid and without what was found before.
std::vector<std::pair<int, double>> bruteForce(const Touching& rig) {
  std::vector<std::pair<int, double>> found;
  const auto& x = rig.x;
  const auto normal = [&](const std::array<int, 3>& t) -> Vec3 { return (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]); };
  for (std::size_t s = 0; s < rig.contact.samples.size(); ++s) {
    const auto& sample = rig.contact.samples[s];
    Vec3 n = Vec3::Zero();
    for (int k = sample.first; k < sample.last; ++k) n += normal(rig.surface.triangles[rig.contact.around[k]]);
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < rig.surface.triangles.size(); ++t) {
      const auto& triangle = rig.surface.triangles[t];
      if (rig.contact.piece[t] == rig.contact.vertex_piece[sample.vertex]) continue;
      const Vec3 a = normal(triangle).normalized(), p = x[sample.vertex];
      if (a.dot(n.normalized()) >= -0.3) continue;
      const double gap = a.dot(p - x[triangle[0]]);
      bool inside = true;
      for (int k = 0; k < 3; ++k) {
        const Vec3 from = x[triangle[k]], to = x[triangle[(k + 1) % 3]], opposite = x[triangle[(k + 2) % 3]];
        const Vec3 in = a.cross(to - from);
        inside = inside && in.dot(p - from) > -0.01 * in.dot(opposite - from);
      }
      if (inside && gap > -0.5 * rig.contact.size[sample.vertex] && std::abs(gap) < std::abs(best)) best = gap;
    }
    if (best < MARGIN * rig.contact.size[sample.vertex]) found.emplace_back(static_cast<int>(s), best);
  }
  return found;
}

TEST(FragmentFinder, FindsWhatTryingEverythingFinds) {
  for (unsigned seed = 0; seed < 5; ++seed) {
    Touching rig({4, 3, 3}, Vec3(1, 0.75, 0.75));
    const std::vector<Vec3> random = randomVectors(8, 1, seed);
    ASSERT_TRUE(rig.cut(plane(Vec3(0.5, 0.37, 0.37), random[0])).changed());
    rig.cut(plane(Vec3(0.45, 0.4, 0.3), random[1]));
    for (int piece = 1; piece < rig.pieces(); ++piece)
      rig.move(piece, 0.05 * random[2 * piece], 0.1 * random[2 * piece + 1].x());
    const std::vector<Candidate> found = rig.find();
    const auto expected = bruteForce(rig);
    EXPECT_GT(expected.size(), 20u);
    std::size_t twins = 0;  // of which one stands for both
    auto at = expected.begin();
    for (const Candidate& candidate : found) {
      const auto& sample = rig.contact.samples[candidate.sample];
      twins += candidate.stiffness > 0.75 * sample.area / candidate.size;
      while (at != expected.end() && at->first < candidate.sample) ++at;
      ASSERT_TRUE(at != expected.end() && at->first == candidate.sample) << seed;
      EXPECT_NEAR(candidate.gap, at->second, 1e-12);
    }
    EXPECT_EQ(found.size() + twins, expected.size()) << seed;
  }
}

TEST(FragmentFinder, FollowsSmallMotionWithoutASearch) {
  Touching rig({4, 4, 4}, Vec3::Ones());
  ASSERT_TRUE(rig.cut(plane(Vec3(0.5, 0.5, 0.55), Vec3(0.2, 0.1, 1))).changed());
  const std::size_t count = rig.find().size();
  rig.move(1, Vec3(0, 0, 0.004));
  const std::vector<Candidate> found = rig.again();
  EXPECT_EQ(found.size(), count);
  const double gap = 0.004 / Vec3(0.2, 0.1, 1).norm();
  for (const Candidate& candidate : found) EXPECT_NEAR(candidate.gap, gap, 1e-12);
  rig.move(1, Vec3(0, 0, 0.5));
  EXPECT_TRUE(rig.again().empty());
}

// A strip bent round until its ends meet, upper side on upper side.
TEST(FragmentFinder, FindsABodyThatTouchesItself) {
  Touching rig({24, 2, 1}, Vec3(2.4, 0.2, 0.1));
  rig.find();
  for (Vec3& x : rig.motion.x) {
    const double turn = 1.02 * 2 * M_PI * x.x() / 2.4, radius = 2.4 / (2 * M_PI) - x.z();
    x = Vec3(radius * std::sin(turn), x.y(), radius * std::cos(turn));
  }
  EXPECT_TRUE(rig.again().empty());  // end faces side by side
  Touching folded({24, 2, 1}, Vec3(2.4, 0.2, 0.1));
  folded.find();
  for (Vec3& x : folded.motion.x)
    if (x.x() > 1.2) x = Vec3(2.4 - x.x(), x.y(), 0.21 - x.z());  // over itself, 0.01 m above
  const std::vector<Candidate> found = folded.again();
  EXPECT_GT(found.size(), 30u);
  for (const Candidate& candidate : found) EXPECT_NEAR(candidate.gap, 0.01, 1e-4);  // less beside the fold
}

}  // namespace
}  // namespace incision
