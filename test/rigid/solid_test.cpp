#include "incision/rigid/solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "incision/base/input_error.h"
#include "incision/rigid/box.h"
#include "incision/rigid/capsule.h"
#include "incision/rigid/cylinder.h"
#include "incision/rigid/half_space.h"
#include "incision/rigid/sphere.h"
#include "support/distance_gradient.h"

namespace incision {
namespace {

constexpr double SPHERE_RADIUS = 0.7, CYLINDER_RADIUS = 0.4, CYLINDER_LENGTH = 1.1, CAPSULE_RADIUS = 0.3,
                 CAPSULE_LENGTH = 0.9;
const Vec3 BOX_SIZE(0.5, 1.2, 0.8);

const Sphere PLAIN_SPHERE(SPHERE_RADIUS);
const Box PLAIN_BOX(BOX_SIZE);
const Cylinder PLAIN_CYLINDER(CYLINDER_RADIUS, CYLINDER_LENGTH);
const Capsule CAPSULE(CAPSULE_RADIUS, CAPSULE_LENGTH);
const HalfSpace HALF_SPACE;

const std::vector<const Solid*> PLAIN = {&PLAIN_SPHERE, &PLAIN_BOX, &PLAIN_CYLINDER, &CAPSULE, &HALF_SPACE};

constexpr int RUNGS = 200;  // samples along each direction of a surface

// Points of the unit circle and of [−1, 1], evenly spread.
Eigen::Vector2d onCircle(int i) {
  const double angle = 2 * M_PI * i / RUNGS;
  return {std::cos(angle), std::sin(angle)};
}
double onLine(int i) { return 2.0 * i / RUNGS - 1; }

std::vector<Vec3> sphereSamples(double radius) {
  std::vector<Vec3> samples;
  for (int i = 0; i <= RUNGS; ++i) {
    const double z = std::cos(M_PI * i / RUNGS), r = std::sin(M_PI * i / RUNGS);
    for (int j = 0; j < RUNGS; ++j) samples.push_back(radius * Vec3(r * onCircle(j).x(), r * onCircle(j).y(), z));
  }
  return samples;
}

std::vector<Vec3> boxSamples(const Vec3& size) {
  std::vector<Vec3> samples;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0})
      for (int i = 0; i <= RUNGS; ++i)
        for (int j = 0; j <= RUNGS; ++j) {
          Vec3 v;
          v[axis] = side, v[(axis + 1) % 3] = onLine(i), v[(axis + 2) % 3] = onLine(j);
          samples.push_back(v.cwiseProduct(size) / 2);
        }
  return samples;
}

std::vector<Vec3> cylinderSamples(double radius, double length) {
  std::vector<Vec3> samples;
  for (int j = 0; j < RUNGS; ++j) {
    const Eigen::Vector2d c = radius * onCircle(j);
    for (int i = 0; i <= RUNGS; ++i) {
      samples.emplace_back(c.x(), c.y(), onLine(i) * length / 2);
      for (const double side : {-1.0, 1.0})
        samples.emplace_back(c.x() * i / RUNGS, c.y() * i / RUNGS, side * length / 2);
    }
  }
  return samples;
}

std::vector<Vec3> capsuleSamples(double radius, double length) {
  std::vector<Vec3> samples;
  for (Vec3 sample : sphereSamples(radius)) {
    sample.z() += sample.z() < 0 ? -length / 2 : length / 2;
    samples.push_back(sample);
  }
  for (int j = 0; j < RUNGS; ++j)
    for (int i = 0; i <= RUNGS; ++i)
      samples.emplace_back(radius * onCircle(j).x(), radius * onCircle(j).y(), onLine(i) * length / 2);
  return samples;
}

std::vector<Vec3> randomPoints(int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  return points;
}

struct Sampled {
  const Solid* solid;
  std::vector<Vec3> samples;
};

std::vector<Sampled> sampledSolids() {
  return {{&PLAIN_SPHERE, sphereSamples(SPHERE_RADIUS)},
          {&PLAIN_BOX, boxSamples(BOX_SIZE)},
          {&PLAIN_CYLINDER, cylinderSamples(CYLINDER_RADIUS, CYLINDER_LENGTH)},
          {&CAPSULE, capsuleSamples(CAPSULE_RADIUS, CAPSULE_LENGTH)}};
}

TEST(SolidDistance, IsThatOfTheNearestOfManySurfacePoints) {
  // Neighbouring samples are at most 2π 0.7 / 200 apart, so one lies within this of each surface point.
  const double spacing = 0.016;
  for (const auto& [solid, samples] : sampledSolids()) {
    for (const Vec3& p : randomPoints(40)) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vec3& sample : samples) nearest = std::min(nearest, (sample - p).norm());
      const double distance = std::abs(solid->distanceTo(p).distance);
      EXPECT_LE(distance, nearest + 1e-12);
      EXPECT_GE(distance, nearest - spacing);
      // From afar a sample beside the nearest point is hardly further: the error is of second order in the spacing.
      EXPECT_GE(distance, nearest - spacing * spacing / std::max(distance, spacing));
    }
  }
}

TEST(SolidDistance, IsNegativeInside) {
  for (const Vec3& p : randomPoints(2000)) {
    const double across = p.head<2>().norm();
    EXPECT_EQ(PLAIN_SPHERE.distanceTo(p).distance < 0, p.norm() < SPHERE_RADIUS);
    EXPECT_EQ(PLAIN_BOX.distanceTo(p).distance < 0, (2 * p.array().abs() < BOX_SIZE.array()).all());
    EXPECT_EQ(PLAIN_CYLINDER.distanceTo(p).distance < 0,
              across < CYLINDER_RADIUS && 2 * std::abs(p.z()) < CYLINDER_LENGTH);
    const double beyond = std::max(0.0, std::abs(p.z()) - CAPSULE_LENGTH / 2);
    EXPECT_EQ(CAPSULE.distanceTo(p).distance < 0, std::hypot(across, beyond) < CAPSULE_RADIUS);
    EXPECT_EQ(HALF_SPACE.distanceTo(p).distance < 0, p.z() < 0);
  }
}

TEST(SolidDistance, NormalIsItsGradient) {
  const double h = 1e-6;
  int compared = 0;
  for (const Solid* solid : PLAIN)
    for (const Vec3& p : randomPoints(500)) {
      const Vec3 normal = solid->distanceTo(p).normal;
      const std::optional<Vec3> gradient = test::distanceGradient(*solid, p, h);
      // The distance's third derivatives are below 1 / (0.01 m)² here, and rounding is 1e-16 / h.
      EXPECT_TRUE(!gradient || (*gradient - normal).norm() < 1e-7);
      compared += gradient.has_value();
    }
  EXPECT_GT(compared, 2400);  // of 2500
}

TEST(SolidDistance, SurfacePointsAreAtZero) {
  for (const auto& [solid, samples] : sampledSolids())
    for (const Vec3& sample : samples) EXPECT_NEAR(solid->distanceTo(sample).distance, 0, 1e-15);
}

TEST(SolidDistance, SteppingBackAlongTheNormalReachesTheSurface) {
  for (const Solid* solid : PLAIN)
    for (const Vec3& p : randomPoints(500)) {
      const SolidDistance d = solid->distanceTo(p);
      EXPECT_NEAR(solid->distanceTo(p - d.distance * d.normal).distance, 0, 1e-15);
    }
}

// Centres, axes, edges, corners, next to nothing beside them, and far off.
TEST(SolidDistance, NormalIsAUnitVectorEverywhere) {
  std::vector<double> coordinates = {0, -0.0, 5e-324, -5e-324, 1e-200, 1e-17, 1e6, -1e200};
  for (const double size :
       {SPHERE_RADIUS, CYLINDER_RADIUS, CYLINDER_LENGTH, CAPSULE_RADIUS, BOX_SIZE.x(), BOX_SIZE.y(), BOX_SIZE.z()})
    for (const double end : {size / 2, -size}) {
      coordinates.push_back(end);
      coordinates.push_back(std::nextafter(end, 10));
    }
  for (const Solid* solid : PLAIN)
    for (const double x : coordinates)
      for (const double y : coordinates)
        for (const double z : coordinates) {
          const SolidDistance d = solid->distanceTo({x, y, z});
          ASSERT_TRUE(std::isfinite(d.distance)) << x << ' ' << y << ' ' << z;
          ASSERT_NEAR(d.normal.norm(), 1, 1e-15) << x << ' ' << y << ' ' << z;
        }
}

TEST(SolidDistance, AtTheCentreTheNearestSurfaceIsMeant) {
  EXPECT_EQ(PLAIN_SPHERE.distanceTo(Vec3::Zero()).distance, -0.7);
  EXPECT_EQ(PLAIN_BOX.distanceTo(Vec3::Zero()).distance, -0.25);
  EXPECT_EQ(std::abs(PLAIN_BOX.distanceTo(Vec3::Zero()).normal.x()), 1);
  EXPECT_EQ(PLAIN_CYLINDER.distanceTo(Vec3::Zero()).distance, -0.4);
  EXPECT_EQ(PLAIN_CYLINDER.distanceTo(Vec3::Zero()).normal.z(), 0);
}

TEST(Solid, ReachesAsFarAsTheFarthestOfManySurfacePoints) {
  const double spacing = 0.016;
  for (const auto& [solid, samples] : sampledSolids()) {
    for (const Vec3& p : randomPoints(40)) {
      const Vec3 n = p.normalized();
      double along = 0, farthest = 0;
      for (const Vec3& sample : samples) {
        along = std::max(along, n.dot(sample));
        farthest = std::max(farthest, sample.norm());
      }
      EXPECT_LE(along, solid->reachAlong(n) + 1e-12);
      EXPECT_GE(along, solid->reachAlong(n) - spacing);
      EXPECT_LE(farthest, solid->reach() + 1e-12);
      EXPECT_GE(farthest, solid->reach() - spacing);
    }
  }
}

TEST(Solid, NoTwoPlanesThatHoldItAreNearerThanItIsThick) {
  for (const Solid* solid : {static_cast<const Solid*>(&PLAIN_SPHERE), static_cast<const Solid*>(&PLAIN_BOX),
                             static_cast<const Solid*>(&PLAIN_CYLINDER), static_cast<const Solid*>(&CAPSULE)}) {
    double least = std::numeric_limits<double>::infinity();
    std::vector<Vec3> normals = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
    for (const Vec3& p : randomPoints(200)) normals.push_back(p.normalized());
    for (const Vec3& n : normals) least = std::min(least, solid->reachAlong(n) + solid->reachAlong(-n));
    EXPECT_NEAR(solid->thickness(), least, 1e-12);
  }
}

TEST(Solid, SizesOutOfRangeAreRefused) {
  for (const double size : {0.0, -1.0, 1e7, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(Sphere(size).check("here"), InputError);
    EXPECT_THROW(Box(Vec3(1, 1, size)).check("here"), InputError);
    EXPECT_THROW(Cylinder(size, 1).check("here"), InputError);
    EXPECT_THROW(Cylinder(1, size).check("here"), InputError);
    EXPECT_THROW(Capsule(size, 1).check("here"), InputError);
    EXPECT_THROW(Capsule(1, size).check("here"), InputError);
  }
  for (const Solid* solid : PLAIN) EXPECT_NO_THROW(solid->check("here"));
}

}  // namespace
}  // namespace incision
