#include "incision/contact/fragments.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

#include "incision/contact/surface_match.h"
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
  std::vector<Candidate> again() { return foundBy(&finder); }
  // By one without any past, which has to search everything.
  std::vector<Candidate> afresh() {
    FragmentFinder other;
    other.surfaceChanged();
    const std::vector<Candidate> found = foundBy(&other);
    searches_afresh += other.pairs().searches();
    return found;
  }
  std::vector<Candidate> foundBy(FragmentFinder* by) {
    x = surfacePositions(surface, motion.x);
    std::vector<Candidate> candidates;
    ahead.resize(v.size());
    for (std::size_t i = 0; i < v.size(); ++i) ahead[i] = 0.01 * v[i];
    by->find(contact, x, ahead, {}, 1, &candidates);
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
  int searches_afresh = 0;
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
  for (double& area : rig.contact.rest_area) area = 0;
  rig.contact.edges.clear();
  EXPECT_TRUE(rig.afresh().empty());
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

std::vector<Candidate> ofFaces(std::vector<Candidate> candidates) {
  const auto edges = [](const Candidate& candidate) { return candidate.partner == Candidate::EDGES; };
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(), edges), candidates.end());
  return candidates;
}

void expectAsAfresh(Touching* rig, unsigned seed) {
  const std::vector<Candidate> found = rig->again(), afresh = rig->afresh();
  ASSERT_EQ(found.size(), afresh.size()) << seed;
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_FALSE(comesBefore(found[i], afresh[i]) || comesBefore(afresh[i], found[i])) << seed;
    ASSERT_EQ(found[i].gap, afresh[i].gap) << seed;
    ASSERT_EQ(found[i].normal, afresh[i].normal) << seed;
  }
}

// The search in boxes leaves out nothing: every sample of one piece against every triangle of the others.
void expectAllFound(const Touching& rig, const std::vector<Candidate>& found, unsigned seed) {
  const auto& [x, ahead] = std::tie(rig.x, rig.ahead);
  std::vector<Vec3> normals, sample_normals;
  for (const auto& [a, b, c] : rig.surface.triangles) normals.push_back((x[b] - x[a]).cross(x[c] - x[a]));
  for (const auto& sample : rig.contact.samples) {
    sample_normals.push_back(Vec3::Zero());
    for (int k = sample.first; k < sample.last; ++k) sample_normals.back() += normals[rig.contact.around[k]];
    sample_normals.back().normalize();
  }
  for (Vec3& n : normals) n.normalize();
  const SkinInStep skin{rig.contact, x, ahead, normals, normals, sample_normals};
  std::set<std::pair<int, int>> expected, candidates;  // samples and pieces that they are before
  for (int s = 0; s < static_cast<int>(rig.contact.samples.size()); ++s)
    for (int t = 0; t < static_cast<int>(normals.size()); ++t) {
      if (rig.contact.piece[t] == rig.contact.vertex_piece[rig.contact.samples[s].vertex]) continue;
      const auto met = meetFace(skin, s, t);
      if (met && met->gap >= 0) expected.insert({s, rig.contact.piece[t]});
    }
  for (const Candidate& candidate : ofFaces(found)) {
    const auto& at = rig.contact;
    candidates.insert({candidate.sample, at.vertex_piece[candidate.other]});
    if (candidate.stiffness * candidate.size > 0.75 * at.samples[candidate.sample].area)  // it stands for its twin too
      for (int s = at.sample_start[candidate.other]; s < at.sample_start[candidate.other + 1]; ++s)
        candidates.insert({s, at.vertex_piece[at.samples[candidate.sample].vertex]});
  }
  EXPECT_GT(expected.size(), 10u);
  EXPECT_TRUE(std::includes(candidates.begin(), candidates.end(), expected.begin(), expected.end())) << seed;
}

TEST(FragmentFinder, FindsWhatTryingEverythingFindsHoweverItsPiecesMove) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    Touching rig({4, 3, 3}, Vec3(1, 0.75, 0.75));
    const std::vector<Vec3> random = randomVectors(60, 1, seed);
    ASSERT_TRUE(rig.cut(plane(Vec3(0.5, 0.37, 0.37), random[0])).changed());
    rig.cut(plane(Vec3(0.45, 0.4, 0.3), random[1]));
    expectAllFound(rig, rig.find(), seed);
    for (int k = 2; k < 30; ++k) {
      rig.move(k % rig.pieces(), 0.02 * random[2 * k], 0.02 * random[2 * k + 1].x());
      expectAsAfresh(&rig, seed);
    }
    expectAllFound(rig, rig.again(), seed);
  }
}

// What was looked at less far is looked at again in time.
TEST(FragmentFinder, FindsWhatTryingEverythingFindsWhereItsPiecesHardlyMove) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    Touching rig({4, 3, 3}, Vec3(1, 0.75, 0.75));
    const std::vector<Vec3> random = randomVectors(60, 1, seed);
    ASSERT_TRUE(rig.cut(plane(Vec3(0.5, 0.37, 0.37), random[0])).changed());
    const Vec3 apart = 0.005 * rig.find().front().normal;  // from piece 1, or towards it
    rig.move(0, apart, 0);
    if (rig.again().front().gap < 0) rig.move(0, -2 * apart, 0);
    rig.again();
    const int searches = rig.finder.pairs().searches();
    for (int k = 1; k < 30; ++k) {
      rig.move(k % rig.pieces(), 0.0007 * random[2 * k], 0.0007 * random[2 * k + 1].x());
      expectAsAfresh(&rig, seed);
      expectAllFound(rig, rig.again(), seed);
    }
    EXPECT_EQ(rig.finder.pairs().searches(), searches) << seed;
  }
}

PlaneCut slit(const Vec3& point, const Vec3& normal, double size) {
  PlaneCut cut = plane(point, normal);
  cut.tangent = normal.unitOrthogonal();
  cut.length = cut.width = size;
  return cut;
}

// While others were near, what a piece has near itself was looked at less far.
TEST(FragmentFinder, FindsWhereAPieceMeetsItselfAlsoWhenTheOthersHaveGone) {
  Touching rig({6, 4, 4}, Vec3(1.5, 1, 1));
  ASSERT_TRUE(rig.cut(plane(Vec3(1.3, 0.5, 0.5), Vec3::UnitX())).changed());
  PlaneCut open = plane(Vec3(0, 0.5, 0.5), Vec3::UnitZ());  // along faces
  open.tangent = Vec3::UnitX();
  open.length = 1.2;
  open.width = 3;
  ASSERT_TRUE(rig.cut(open).changed());
  ASSERT_EQ(rig.pieces(), 2);
  const int slit = rig.step.pieceOf()[0];
  std::set<int> above;  // copies of what the slit lies below
  for (const Part& part : rig.mesh.parts()) {
    double z = 0;
    for (int node : rig.mesh.mesh().elements[part.element]) z += rig.mesh.mesh().nodes[node].z() / 4;
    if (z > 0.5 && rig.step.pieceOf()[part.copies[0]] == slit) above.insert(part.copies.begin(), part.copies.end());
  }
  // Over the middles of cells, so that points soon come over other triangles.
  for (int copy : above) rig.motion.x[copy] += Vec3(0.1, 0.09, 0);
  rig.find();
  for (int k = 0; k < 3; ++k) rig.again();
  rig.move(1 - slit, Vec3(9, 0, 0));
  rig.again();
  std::size_t found = 0;
  for (int k = 0; k < 4; ++k) {
    for (int copy : above) rig.motion.x[copy] += Vec3(0.01, 0.018, -0.0002);
    expectAsAfresh(&rig, 0);
    found += ofFaces(rig.again()).size();
  }
  EXPECT_GT(found, 10u);
}

// Pieces move, slits are cut into them, and now and then one falls apart.
TEST(FragmentFinder, FindsTheSameWhateverWasThereBeforeTheSurfaceChanged) {
  int found = 0, searches = 0, afresh = 0;
  for (unsigned seed = 0; seed < 3; ++seed) {
    Touching rig({6, 5, 5}, Vec3(1.2, 1, 1));
    const std::vector<Vec3> random = randomVectors(120, 1, seed);
    ASSERT_TRUE(rig.cut(plane(Vec3(0.6, 0.49, 0.51), random[0])).changed());
    rig.find();
    for (int k = 1; k < 14; ++k) {
      for (int piece = 0; piece < rig.pieces(); ++piece)
        rig.move(piece, 0.004 * random[4 * k + piece % 4], 0.004 * random[4 * k + 1].y());
      const Vec3 middle = Vec3(0.6, 0.5, 0.5) + random[4 * k].cwiseProduct(Vec3(0.5, 0.4, 0.4));
      rig.cut(k % 7 == 0 ? plane(middle, random[4 * k + 2]) : slit(middle, random[4 * k + 2], 0.3));
      const int before = rig.finder.pairs().searches();
      found += static_cast<int>(rig.find().size());
      searches += rig.finder.pairs().searches() - before;
      expectAsAfresh(&rig, seed);
    }
    afresh += rig.searches_afresh;
  }
  EXPECT_GT(found, 2'000);
  EXPECT_LT(2 * searches, afresh);
}

// Copies that two cuts have made of the same mesh have the same numbers, at other places.
TEST(SurfaceMatch, TakesNothingForWhatIsElsewhere) {
  Touching one({4, 4, 4}, Vec3::Ones()), other({4, 4, 4}, Vec3::Ones());
  ASSERT_TRUE(one.cut(plane(Vec3(0.5, 0.5, 0.55), Vec3(0.2, 0.1, 1))).changed());
  ASSERT_TRUE(other.cut(plane(Vec3(0.45, 0.5, 0.5), Vec3(1, 0.1, 0.2))).changed());
  one.find();
  other.find();
  const SurfaceMatch known = match(SurfaceOutline(one.contact), other.contact);
  int same = 0, copies = 0;
  for (std::size_t v = 0; v < known.vertices.size(); ++v) {
    const int is = known.vertices[v];
    copies += one.surface.vertices[v].copies[0] >= static_cast<int>(one.mesh.mesh().nodes.size());
    if (is < 0) continue;
    ++same;
    EXPECT_LT((one.contact.rest[v] - other.contact.rest[is]).norm(), 1e-12);
  }
  EXPECT_GT(same, 50);
  EXPECT_GT(copies, 20);
  const SurfaceMatch itself = match(SurfaceOutline(one.contact), one.contact);
  EXPECT_TRUE(itself.new_triangles.empty() && itself.new_samples.empty() && itself.new_edges.empty());
}

TEST(FragmentFinder, LooksOnlyForWhatIsFreshWhereASlitIsCut) {
  Touching rig({8, 8, 8}, Vec3::Ones());
  ASSERT_TRUE(rig.cut(plane(Vec3(0.5, 0.5, 0.55), Vec3(0.2, 0.1, 1))).changed());
  rig.find();
  const int searches = rig.finder.pairs().searches();
  ASSERT_TRUE(rig.cut(slit(Vec3(0.5, 0.1, 0.2), Vec3(1, 0.1, 0.2), 0.2)).changed());
  rig.find();
  EXPECT_EQ(rig.finder.pairs().searches(), searches);
  expectAsAfresh(&rig, 0);
}

TEST(FragmentFinder, FollowsSmallMotionWithoutASearch) {
  Touching rig({4, 4, 4}, Vec3::Ones());
  ASSERT_TRUE(rig.cut(plane(Vec3(0.5, 0.5, 0.55), Vec3(0.2, 0.1, 1))).changed());
  const std::size_t count = ofFaces(rig.find()).size();
  const int searches = rig.finder.pairs().searches();
  rig.move(1, Vec3(0, 0, 0.004));
  const std::vector<Candidate> found = ofFaces(rig.again());
  EXPECT_EQ(rig.finder.pairs().searches(), searches);
  EXPECT_GE(found.size(), count);  // twins that have slid apart are two
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
