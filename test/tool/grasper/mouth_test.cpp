#include "incision/tool/grasper/mouth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/forceps.h"

namespace incision::test {
namespace {

constexpr ForcepsForm FORM;

/// Between the jaws in the plane z = 0 at a share of their length.
Vec3 amid(double share, double y = 0) { return Vec3(share * FORM.length(), y, 0); }

TEST(Mouth, IsWhatLiesBetweenTheJaws) {
  for (const bool both : {true, false})
    for (const double angle : {0.0, 0.1, 0.4}) {
      const Mouth mouth(forceps(FORM, both), angle);
      // The middle of what is open: a single jaw opens one way.
      const double half = both ? 0 : angle / 2;
      const auto turned = [&](const Vec3& p) -> Vec3 { return Eigen::AngleAxisd(-half, Vec3::UnitY()) * p; };
      for (const double share : {0.2, 0.5, 0.9})
        for (const double y : {-0.45, 0.0, 0.45})
          EXPECT_TRUE(mouth.isBetween(turned(amid(share, y * FORM.width())))) << both << angle << share << y;
      EXPECT_FALSE(mouth.isBetween(turned(amid(1.05)))) << both << angle;
      EXPECT_FALSE(mouth.isBetween(turned(amid(0.5, 0.55 * FORM.width()))));
      EXPECT_FALSE(mouth.isBetween(amid(-3)));
      EXPECT_FALSE(mouth.isBetween(Vec3(0.5 * FORM.length(), 0, 3 * FORM.length())));
      const Vec3 behind(0.5 * FORM.length(), 0, -FORM.gap() / 2 - 1.01 * FORM.thickness());
      EXPECT_FALSE(mouth.isBetween(both ? Eigen::AngleAxisd(angle, Vec3::UnitY()) * behind : behind));
    }
}

// What is pressed into a jaw lies before it, but not what is deep in it or behind it.
TEST(Mouth, HoldsWhatIsPressedIntoAJawALittle) {
  const Mouth mouth(forceps(), 0);
  const auto at = [](double beyond) { return Vec3(FORM.length() / 2, 0, FORM.gap() / 2 + beyond * FORM.thickness()); };
  EXPECT_TRUE(mouth.isBetween(at(0)));
  EXPECT_TRUE(mouth.isBetween(at(0.1)));
  EXPECT_TRUE(mouth.isBetween(-at(0.1) + Vec3(FORM.length(), 0, 0)));
  EXPECT_FALSE(mouth.isBetween(at(0.5)));
  EXPECT_FALSE(mouth.isBetween(at(0.9)));
  EXPECT_FALSE(mouth.isBetween(at(1.1)));
}

TEST(Mouth, PointsAreSpreadOverAllOfIt) {
  for (const std::string type : {"revolute", "prismatic"}) {
    const double open = type == "revolute" ? 0.1 : 0.001;
    const Mouth mouth(forceps(FORM, true, type), open);
    ASSERT_GT(mouth.points().size(), 200u) << type;
    for (const Vec3& point : mouth.points()) EXPECT_TRUE(mouth.isBetween(point));
    EXPECT_GT(mouth.box().sizes().x(), 0.85 * FORM.length());
    EXPECT_GT(mouth.box().sizes().y(), 0.8 * FORM.width());
    EXPECT_GT(mouth.box().sizes().z(), 0.5 * (FORM.gap() + 0.002));
    // Nowhere in it is one farther than a fifth of its length from one of the first 64.
    for (double x = 0.05; x < 1; x += 0.1) {
      double nearest = 1;
      for (int i = 0; i < 64; ++i) nearest = std::min(nearest, (mouth.points()[i] - amid(x)).norm());
      EXPECT_LT(nearest, 0.15 * FORM.length()) << x;
    }
  }
}

TEST(Mouth, HasNoRoomWhereTheJawsMeet) {
  ForcepsForm form;
  const Mouth closed(forceps(form), -0.1), open(forceps(form), 0.05);
  // At −0.1 the jaws overlap from a quarter of their length on.
  for (const Vec3& point : closed.points()) EXPECT_LT(point.x(), 0.3 * form.length());
  EXPECT_GT(open.points().size(), 200u);
}

}  // namespace
}  // namespace incision::test
