#include <gtest/gtest.h>

#include <memory>

#include "incision/contact/solid_contacts.h"
#include "incision/rigid/mesh_solid.h"
#include "incision/surface/current_surface.h"
#include "support/rig.h"
#include "support/solid_meshes.h"

namespace incision::test {
namespace {

/// A mesh that counts how often it is asked what takes long.
class CountingMesh : public Solid {
 public:
  explicit CountingMesh(const TriangleMesh& mesh) : solid_(closeMesh(mesh, &remark_)) {}

  int asked() const { return asked_; }

  SolidDistance distanceTo(const Vec3& point) const override {
    ++asked_;
    return solid_.distanceTo(point);
  }
  SolidDistance distanceAgainst(const Vec3& point, const Vec3& n) const override {
    ++asked_;
    return solid_.distanceAgainst(point, n);
  }
  double thickness() const override { return solid_.thickness(); }
  double reachAlong(const Vec3& n) const override {
    ++asked_;
    return solid_.reachAlong(n);
  }
  double reach() const override { return solid_.reach(); }
  bool isConvex() const override { return solid_.isConvex(); }
  bool isClearOf(const Vec3& point, double room) const override { return solid_.isClearOf(point, room); }
  void check(const std::string& where) const override { solid_.check(where); }
  Drawing drawing() const override { return solid_.drawing(); }

 private:
  std::string remark_;
  MeshSolid solid_;
  mutable int asked_ = 0;
};

struct Search {
  int vertices = 0, asked = 0, candidates = 0;
};

/// Of a cube of 0.7 m round the origin, whose surface has elements of 0.05 m, for contacts with a mesh at `place`.
Search searchContacts(const TriangleMesh& triangles, const Vec3& place) {
  const CutMesh mesh(block({14, 14, 14}, Vec3::Constant(0.7), Vec3::Constant(-0.35)), 1);
  const Materials materials(mesh.mesh(), {1e5, 0.3, 1000, 0, 0}, {});
  const CurrentSurface surface(mesh);
  ContactSkin skin(surface, materials, 1);
  const std::vector<Vec3> x = restPositions(mesh);
  const Motion motion{x, std::vector<Vec3>(x.size(), Vec3::Zero())};
  const std::vector<int> piece(x.size(), 0);
  const std::vector<double> inertia(x.size(), 1), mass = {1};
  StepSpan span;
  span.time_step = 0.01;
  skin.begin({span, mesh, piece, motion, motion.v, inertia, mass});
  const auto solid = std::make_shared<CountingMesh>(triangles);
  Obstacle shape;
  shape.solid = solid;
  shape.pose.position = place;
  Obstacles obstacles;
  obstacles.shapes = {shape};
  const std::vector<RigidMotion> motions;
  std::vector<Candidate> candidates;
  findSolidContacts(skin, span, {obstacles, motions}, {}, &candidates);
  return {static_cast<int>(skin.x().size()), solid->asked(), static_cast<int>(candidates.size())};
}

// What a step costs with a mesh of 100,000 triangles is what it costs to ask it, and that few vertices do.
TEST(MeshObstacles, AreAskedByTheVerticesNearTheirSurfaceAlone) {
  const TriangleMesh ring = torusMesh(0.8, 0.2, 160);
  ASSERT_GT(ring.triangles.size(), 100'000u);
  const Search within = searchContacts(ring, Vec3::Zero());
  EXPECT_GT(within.vertices, 1000);
  EXPECT_EQ(within.asked, 0);
  EXPECT_EQ(within.candidates, 0);

  // The cube's upper face lies on the ring's outer side from below.
  const Search beside = searchContacts(ring, Vec3(0.8, 0, 0.549));
  EXPECT_GT(beside.candidates, 0);
  EXPECT_LT(beside.asked, 0.2 * beside.vertices);
}

}  // namespace
}  // namespace incision::test
