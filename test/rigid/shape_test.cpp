#include "incision/rigid/shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace incision {
namespace {

const Shape SPHERE = {ShapeKind::SPHERE, Vec3(0.7, 0, 0)};
const Shape BOX = {ShapeKind::BOX, Vec3(0.5, 1.2, 0.8)};
const Shape CYLINDER = {ShapeKind::CYLINDER, Vec3(0.4, 0, 1.1)};
const Shape HALF_SPACE = {ShapeKind::HALF_SPACE, Vec3::Zero()};

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

bool contains(const Shape& shape, const Vec3& p) {
  switch (shape.kind) {
    case ShapeKind::SPHERE:
      return p.squaredNorm() < shape.size[0] * shape.size[0];
    case ShapeKind::BOX:
      return (2 * p.array().abs() < shape.size.array()).all();
    case ShapeKind::CYLINDER:
      return p.head<2>().squaredNorm() < shape.size[0] * shape.size[0] && 2 * std::abs(p.z()) < shape.size[2];
    default:
      return p.z() < 0;
  }
}

std::vector<Vec3> randomPoints(int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1.5, 1.5);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
  return points;
}

struct Sampled {
  Shape shape;
  std::vector<Vec3> samples;
};

std::vector<Sampled> sampledShapes() {
  return {{SPHERE, sphereSamples(SPHERE.size[0])},
          {BOX, boxSamples(BOX.size)},
          {CYLINDER, cylinderSamples(CYLINDER.size[0], CYLINDER.size[2])}};
}

const std::vector<Shape> ALL = {SPHERE, BOX, CYLINDER, HALF_SPACE};

TEST(ShapeDistance, IsThatOfTheNearestOfManySurfacePoints) {
  // Neighbouring samples are at most 2π 0.7 / 200 apart, so one lies within this of each surface point.
  const double spacing = 0.016;
  for (const auto& [shape, samples] : sampledShapes()) {
    for (const Vec3& p : randomPoints(40)) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vec3& sample : samples) nearest = std::min(nearest, (sample - p).norm());
      const double distance = std::abs(distanceTo(shape, p).distance);
      EXPECT_LE(distance, nearest + 1e-12);
      EXPECT_GE(distance, nearest - spacing);
      // From afar a sample beside the nearest point is hardly further: the error is of second order in the spacing.
      EXPECT_GE(distance, nearest - spacing * spacing / std::max(distance, spacing));
    }
  }
}

TEST(ShapeDistance, IsNegativeInside) {
  for (const Shape& shape : ALL)
    for (const Vec3& p : randomPoints(2000)) EXPECT_EQ(distanceTo(shape, p).distance < 0, contains(shape, p));
}

TEST(ShapeDistance, NormalIsItsGradient) {
  const double h = 1e-6;
  int compared = 0;
  for (const Shape& shape : ALL)
    for (const Vec3& p : randomPoints(500)) {
      const Vec3 normal = distanceTo(shape, p).normal;
      Vec3 gradient;
      bool smooth = true;
      for (int axis = 0; axis < 3; ++axis) {
        const Vec3 step = h * Vec3::Unit(axis);
        const ShapeDistance more = distanceTo(shape, p + step), less = distanceTo(shape, p - step);
        gradient[axis] = (more.distance - less.distance) / (2 * h);
        smooth = smooth && (more.normal - less.normal).norm() < 1e-3;  // no kink in between
      }
      // The distance's third derivatives are below 1 / (0.01 m)² here, and rounding is 1e-16 / h.
      EXPECT_TRUE(!smooth || (gradient - normal).norm() < 1e-7);
      compared += smooth;
    }
  EXPECT_GT(compared, 1900);  // of 2000
}

TEST(ShapeDistance, SurfacePointsAreAtZero) {
  for (const auto& [shape, samples] : sampledShapes())
    for (const Vec3& sample : samples) EXPECT_NEAR(distanceTo(shape, sample).distance, 0, 1e-15);
}

TEST(ShapeDistance, SteppingBackAlongTheNormalReachesTheSurface) {
  for (const Shape& shape : ALL)
    for (const Vec3& p : randomPoints(500)) {
      const ShapeDistance d = distanceTo(shape, p);
      EXPECT_NEAR(distanceTo(shape, p - d.distance * d.normal).distance, 0, 1e-15);
    }
}

// Centres, axes, edges, corners, next to nothing beside them, and far off.
TEST(ShapeDistance, NormalIsAUnitVectorEverywhere) {
  std::vector<double> coordinates = {0, -0.0, 5e-324, -5e-324, 1e-200, 1e-17, 1e6, -1e200};
  for (const Shape& shape : ALL)
    for (const double size : {shape.size[0], shape.size[1], shape.size[2]})
      for (const double end : {size / 2, -size}) {
        coordinates.push_back(end);
        coordinates.push_back(std::nextafter(end, 10));
      }
  for (const Shape& shape : ALL)
    for (const double x : coordinates)
      for (const double y : coordinates)
        for (const double z : coordinates) {
          const ShapeDistance d = distanceTo(shape, {x, y, z});
          ASSERT_TRUE(std::isfinite(d.distance)) << x << ' ' << y << ' ' << z;
          ASSERT_NEAR(d.normal.norm(), 1, 1e-15) << x << ' ' << y << ' ' << z;
        }
}

TEST(ShapeDistance, AtTheCentreTheNearestSurfaceIsMeant) {
  EXPECT_EQ(distanceTo(SPHERE, Vec3::Zero()).distance, -0.7);
  EXPECT_EQ(distanceTo(BOX, Vec3::Zero()).distance, -0.25);
  EXPECT_EQ(std::abs(distanceTo(BOX, Vec3::Zero()).normal.x()), 1);
  EXPECT_EQ(distanceTo(CYLINDER, Vec3::Zero()).distance, -0.4);
  EXPECT_EQ(distanceTo(CYLINDER, Vec3::Zero()).normal.z(), 0);
}

}  // namespace
}  // namespace incision
