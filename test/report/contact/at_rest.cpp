// What lies, stands and is pressed: problems whose end is at rest.
#include "report/clock.h"
#include "report/contact/problems.h"
#include "support/hertz.h"
#include "support/rig.h"

namespace incision::report {
namespace {

constexpr double DENSITY = 1000, STIFF = 1e6, SOFT = 1e5;  // [kg/m³], [Pa]
constexpr double STEP = 0.01;                              // [s]
constexpr int STEPS = 200;                                 // until what swings has come to rest
constexpr double RAMP = 0.5;                               // of loads [s], longer than anything swings
constexpr double FRICTION = 0.3;

Scene onTheGround(const std::array<int, 3>& cells, const Vec3& size) {
  Scene scene;
  scene.body.grid = GridSettings{cells, size, Vec3::Zero()};
  scene.body.material = {STIFF, 0, DENSITY, 0, 2e-3};  // ν = 0: nothing widens, so the answers are exact
  scene.solver.time_step = STEP;
  scene.contact = ContactSettings();
  scene.contact->ground = 0;
  scene.contact->friction = FRICTION;
  return scene;
}

/// Takes the steps until it rests, and then the value.
template <typename Value>
ContactRun restOf(const Scene& scene, int across, const Value& value) {
  const TetMesh mesh = loadMesh(scene);
  const Clock clock;
  DeformableBody body(scene, mesh);
  for (int k = 0; k < STEPS; ++k) body.step();
  const double ms = clock.ms();
  return {static_cast<int>(mesh.elements.size()), across, STEP, ms, value(body),
          static_cast<int>(body.unsettledSteps())};
}

}  // namespace

ContactProblem hertz(bool quick) {
  const Material material = {1e6, 0.3, 1e-9, 0, 0};
  const double depth = 0.02;
  ContactCurve curve = {"graded grid", test::hertzForce(material, depth), {}};
  for (const int cells : quick ? std::vector<int>{4, 6, 9, 12} : std::vector<int>{4, 6, 9, 12, 18, 24}) {
    const Clock clock;
    const double force = test::hertzForces(cells, {depth}, material)[0];
    // Of the finest cells, as wide as 0.24 m by `cells`, across the circle of contact, 2 √(R d) wide.
    const int across = static_cast<int>(std::lround(2 * std::sqrt(depth) * cells / 0.24));
    curve.runs.push_back({24 * cells * cells * cells, across, 1, clock.ms(), force});
  }
  return {"sphere pressed into a block", "force", {curve}};
}

// Tractions on all sides but the lowest are those of a uniform stress, so the strain is uniform too.
ContactProblem heldLayer(bool quick) {
  const double length = 0.4, height = 0.1, pressure = 1000, shear = 0.8 * FRICTION * pressure;
  ContactCurve curve = {"grid", shear * height / (SOFT / 2), {}};
  for (const int cells : quick ? std::vector<int>{1, 2} : std::vector<int>{1, 2, 3, 4}) {
    Scene scene = onTheGround({4 * cells, 4 * cells, cells}, Vec3(length, length, height));
    scene.gravity.setZero();
    scene.body.material.young_modulus = SOFT;
    scene.loads = {{slab(2, height), Vec3(shear, 0, -pressure), RAMP}};
    for (const double x : {0.0, length}) scene.loads.push_back({slab(0, x), Vec3(0, 0, x > 0 ? shear : -shear), RAMP});
    curve.runs.push_back(restOf(scene, cells, [&](const DeformableBody& body) {
      return meanDisplacement(body, height).x() - meanDisplacement(body, 0).x();
    }));
  }
  return {"layer held by friction", "shear of its top", {curve}};
}

ContactProblem stack(bool quick) {
  const Vec3 size(0.1, 0.1, 0.3);
  ContactProblem problem = {"column of three pieces", "how far its top sinks", {}};
  for (const bool cut : {false, true}) {
    ContactCurve& curve = problem.curves.emplace_back();
    curve.name = cut ? "cut into three" : "whole";
    curve.answer = DENSITY * G * size.z() * size.z() / (2 * STIFF);
    for (const int cells : quick ? std::vector<int>{2, 3} : std::vector<int>{2, 3, 4, 6}) {
      Scene scene = onTheGround({cells, cells, 3 * cells}, size);
      if (cut)
        for (const double z : {0.107, 0.211}) scene.cuts.push_back({0, plane(Vec3(0, 0, z), Vec3::UnitZ())});
      curve.runs.push_back(
          restOf(scene, cells, [&](const DeformableBody& body) { return -meanDisplacement(body, size.z()).z(); }));
    }
  }
  return problem;
}

}  // namespace incision::report
