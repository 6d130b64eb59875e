#include <gtest/gtest.h>

#include <algorithm>

#include "incision/contact/body_contact.h"
#include "support/contacts.h"
#include "support/given_springs.h"
#include "support/overlap.h"
#include "support/random.h"
#include "support/sanitized.h"

namespace incision::test {
namespace {

/// Two halves of a bar, 2 × 2 × 2 cells each, that fly towards each other without weight.
struct Meeting : Rig {
  /// `speed`: at which they come nearer, in elements a step. Faces meet flat, or as random turns have them.
  Meeting(double young_modulus, double speed, bool turned, unsigned seed)
      : Rig(block({4, 2, 2}, Vec3(0.2, 0.1, 0.1)), settings(young_modulus)),
        surface(mesh),
        skin(surface, materials, 1),
        contact(ContactSettings(), obstacles, motions, &skin),
        couplers({&contact}) {
    EXPECT_TRUE(cut(plane(Vec3(0.1, 0.05, 0.05), Vec3::UnitX())).changed());
    surface.changed();
    couplers.changed(mesh);
    Random random(seed);
    const double far = turned ? 0.19 : 0.12;  // apart, so that nothing touches
    const double further = random.uniform(0, speed) * ELEMENT;
    const Vec3 aside = 0.06 * Vec3(0, random.uniform(-1, 1), random.uniform(-1, 1));
    for (const int half : {0, 1}) {
      const Mat3 turn = turned ? random.rotation() : Mat3::Identity();
      const Vec3 from(half == 0 ? 0.05 : 0.15, 0.05, 0.05), to = half * (Vec3(far + further, 0, 0) + aside);
      for (std::size_t c = 0; c < motion.x.size(); ++c) {
        if (step.pieceOf()[c] != half) continue;
        motion.x[c] = turn * (motion.x[c] - from) + to;
        motion.v[c].x() = (half == 0 ? 0.5 : -0.5) * speed * ELEMENT / time_step;
      }
    }
  }

  static RigSettings settings(double young_modulus) {
    RigSettings settings;
    settings.material = {young_modulus, 0.3, 1000, 0, 1e-3};
    settings.solver = {0.01, Method::AUTO, 1e-6, 1};
    return settings;
  }

  /// The deepest overlap until they have parted again, in elements.
  double deepest(int steps) {
    double deepest = 0;
    for (int k = 0; k < steps; ++k) {
      EXPECT_TRUE(advanceWith(this, &couplers));
      deepest = std::max(deepest, Overlap(surface.get(), surfacePositions(surface.get(), motion.x)).deepest());
    }
    return deepest / ELEMENT;
  }

  CurrentSurface surface;
  ContactSkin skin;
  Obstacles obstacles;
  std::vector<RigidMotion> motions;  // of the obstacles' links: there are none
  BodyContact contact;
  Couplers couplers;
};

/// Of many meetings, ascending.
std::vector<double> deepestOfMeetings(double young_modulus, double speed, bool turned) {
  std::vector<double> deepest;
  for (unsigned seed = 0; seed < (SANITIZED ? 2 : 30); ++seed)
    deepest.push_back(Meeting(young_modulus, speed, turned, seed).deepest(static_cast<int>(12 + 10 / speed)));
  std::sort(deepest.begin(), deepest.end());
  return deepest;
}

TEST(Fragments, WhoseFacesMeetAreStoppedUpToAnElementAStep) {
  for (const double young_modulus : {1e6, 1e8})
    for (const double speed : {0.25, 0.5, 1.0})
      EXPECT_LT(deepestOfMeetings(young_modulus, speed, false).back(), 0.08) << young_modulus << ' ' << speed;
}

// What else meets while a step is solved, because others have turned a piece, is seen when the next one starts: some
// edges are too deep then.
TEST(Fragments, ThatMeetAnyhowAreStoppedUpToAQuarterOfAnElementAStepAndMostlyBeyond) {
  for (const double young_modulus : {1e6, 1e8}) {
    EXPECT_LT(deepestOfMeetings(young_modulus, 0.25, true).back(), 0.1) << young_modulus;
    for (const double speed : {0.5, 1.0}) {
      const std::vector<double> deepest = deepestOfMeetings(young_modulus, speed, true);
      EXPECT_LT(deepest[deepest.size() / 2], 0.04) << young_modulus << ' ' << speed;
      EXPECT_LT(deepest[deepest.size() * 8 / 10], 0.1) << young_modulus << ' ' << speed;
    }
  }
}

}  // namespace
}  // namespace incision::test
