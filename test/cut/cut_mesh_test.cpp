#include "incision/cut/cut_mesh.h"

#include <gtest/gtest.h>

#include "support/cut_laws.h"
#include "support/cuts.h"
#include "support/deformed_mesh.h"
#include "support/scenes.h"

namespace incision {
namespace {

using test::DeformedMesh;
using test::plane;
using test::rectangle;

TEST(CutMesh, UncutIsOnePartAnElementAndOneCopyANode) {
  const DeformedMesh cube(gridMesh(CUBE));
  EXPECT_EQ(cube.mesh.parts().size(), cube.mesh.mesh().elements.size());
  EXPECT_EQ(cube.mesh.numCopies(), 125);
  EXPECT_EQ(cube.mesh.numCracks(), 0);
  EXPECT_EQ(cube.pieces(), 1);
  test::expectSoundCutMesh(cube.mesh);
}

TEST(Bounds, ARectangleInsideLeavesOnePiece) {
  DeformedMesh cube(gridMesh(CUBE));
  const Insertion done = cube.cut(rectangle(Vec3(0.5, 0.5, 0.55), Vec3::UnitZ(), Vec3::UnitX(), 0.6, 0.6));
  EXPECT_TRUE(done.changed());
  EXPECT_GT(done.out_of_bounds, 0);
  EXPECT_EQ(cube.pieces(), 1);
  test::expectSoundCutMesh(cube.mesh);
}

TEST(Bounds, ARectangleSmallerThanTheElementsChangesNothing) {
  DeformedMesh cube(gridMesh(CUBE));
  const Insertion done = cube.cut(rectangle(Vec3(0.51, 0.53, 0.6), Vec3::UnitZ(), Vec3::UnitX(), 1e-3, 1e-3));
  EXPECT_FALSE(done.changed());
  EXPECT_GT(done.out_of_bounds, 0);
  EXPECT_EQ(cube.mesh.numCracks(), 0);
  EXPECT_EQ(cube.mesh.parts().size(), cube.mesh.mesh().elements.size());
}

TEST(Bounds, TakeAnElementExactlyWhenTheyHoldTheSectionsCentroid) {
  test::Random random(9);
  for (int run = 0; run < 50; ++run) {
    const DeformedMesh whole(test::jitteredGrid(CUBE, 0.2, &random));
    DeformedMesh bounded = whole, unbounded = whole;
    const PlaneCut cut = random.rectangle(CUBE, 0.2, 0.9);
    bounded.cut(cut);
    unbounded.cut(plane(cut.point, cut.normal));
    const Vec3 n = cut.normal.normalized(), t = (cut.tangent - cut.tangent.dot(n) * n).normalized(), b = n.cross(t);
    for (int e = 0; e < static_cast<int>(whole.mesh.mesh().elements.size()); ++e) {
      const bool cuts = bounded.mesh.parts()[e].next >= 0;
      if (unbounded.mesh.parts()[e].next < 0) {
        EXPECT_FALSE(cuts);
        continue;
      }
      Vec3 r = -cut.point;
      const Polytope& polytope = unbounded.mesh.polytope(e);
      for (const Facet& facet : polytope.facets) {
        if (facet.crack != 0) continue;
        std::vector<Barycentric> section;
        for (int c : facet.corners) section.push_back(polytope.corners[c]);
        const Barycentric centre = polygonCentroid(section);
        for (int I = 0; I < 4; ++I) r += centre[I] * whole.mesh.mesh().nodes[whole.mesh.mesh().elements[e][I]];
      }
      EXPECT_EQ(cuts, std::abs(t.dot(r)) <= cut.length / 2 && std::abs(b.dot(r)) <= cut.width / 2);
    }
  }
}

TEST(Bounds, ApplyInTheConfigurationInWhichTheCrackIsGiven) {
  // Stretched to twice its length, the body has its middle where its end was.
  DeformedMesh cube(gridMesh(CUBE));
  for (Vec3& x : cube.x) x.x() *= 2;
  cube.cut(rectangle(Vec3(1.1, 0.5, 0.5), Vec3::UnitX(), Vec3::UnitY(), 3, 3));
  EXPECT_EQ(cube.pieces(), 2);
  for (int p = 0; p < static_cast<int>(cube.mesh.parts().size()); ++p)
    if (cube.mesh.parts()[p].next >= 0 || p >= static_cast<int>(cube.mesh.mesh().elements.size()))
      for (const Facet& facet : cube.mesh.polytope(p).facets)
        if (facet.crack >= 0)
          for (int c : facet.corners) {
            double X = 0;
            for (int I = 0; I < 4; ++I)
              X += cube.mesh.polytope(p).corners[c][I] *
                   cube.mesh.mesh().nodes[cube.mesh.mesh().elements[cube.mesh.parts()[p].element][I]].x();
            EXPECT_NEAR(X, 0.55, 1e-14);
          }
}

TEST(Again, TheSameCutDoesNothing) {
  test::Random random(10);
  for (int run = 0; run < 100; ++run) {
    DeformedMesh cube(test::jitteredGrid(CUBE, 0.2, &random));
    if (run % 2) cube.shake(0.01, &random);
    const PlaneCut cut = run % 4 < 2 ? random.plane(CUBE) : random.rectangle(CUBE, 0.5, 1);
    if (!cube.cut(cut).changed()) continue;
    const int copies = cube.mesh.numCopies();
    const std::size_t parts = cube.mesh.parts().size();
    const Insertion again = cube.cut(cut);
    EXPECT_FALSE(again.changed()) << run << ": split " << again.parts_split << ", severed " << again.faces_severed;
    EXPECT_EQ(cube.mesh.numCopies(), copies);
    EXPECT_EQ(cube.mesh.parts().size(), parts);
    EXPECT_EQ(cube.mesh.numCracks(), 1);
  }
}

TEST(Again, TheSameCutAlongFacesDoesNothing) {
  DeformedMesh cube(gridMesh(CUBE));
  EXPECT_TRUE(cube.cut(plane(Vec3(0.5, 0, 0), Vec3::UnitX())).changed());
  EXPECT_FALSE(cube.cut(plane(Vec3(0.5, 0, 0), Vec3::UnitX())).changed());
  EXPECT_FALSE(cube.cut(plane(Vec3(0.5, 0, 0), -Vec3::UnitX())).changed());
}

TEST(Again, TheSameCutTurnedRoundDoesNothing) {
  test::Random random(11);
  for (int run = 0; run < 50; ++run) {
    DeformedMesh cube(test::jitteredGrid(CUBE, 0.2, &random));
    PlaneCut cut = random.plane(CUBE);
    EXPECT_TRUE(cube.cut(cut).changed());
    cut.normal = -cut.normal;
    EXPECT_FALSE(cube.cut(cut).changed());
  }
}

TEST(Again, ACutWellBesideAnOlderOneIsNew) {
  DeformedMesh cube(gridMesh(CUBE));
  cube.cut(plane(Vec3(0.6, 0, 0), Vec3::UnitX()));
  EXPECT_TRUE(cube.cut(plane(Vec3(0.6 + 0.01, 0, 0), Vec3::UnitX())).changed());
  EXPECT_EQ(cube.pieces(), 3);
}

TEST(Limits, ACutIntoTooManyPartsChangesNothing) {
  TetMesh element;
  element.nodes = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  element.elements = {{0, 1, 2, 3}};
  DeformedMesh body(element);
  // n planes of each of three directions make n³ zones of a block, of which the tetrahedron has more than a sixth.
  const int n = 29;
  const auto state = [&] { return std::make_tuple(body.mesh.numCopies(), body.mesh.parts().size(), body.pieces()); };
  bool refused = false;
  for (int k = 0; k < 3 * n && !refused; ++k) {
    const auto before = state();
    const PlaneCut cut = plane(Vec3::Constant((k / 3 + 0.51) / n), Vec3::Unit(k % 3) + Vec3(0.011, 0.017, -0.013));
    try {
      body.cut(cut);
    } catch (const InputError& error) {
      refused = true;
      EXPECT_EQ(state(), before);
      EXPECT_NE(std::string(error.what()).find(std::to_string(MAX_PARTS_PER_ELEMENT)), std::string::npos);
    }
    EXPECT_LE(static_cast<int>(body.mesh.parts().size()), MAX_PARTS_PER_ELEMENT);
  }
  EXPECT_TRUE(refused);
}

}  // namespace
}  // namespace incision
