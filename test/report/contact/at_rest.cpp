// What lies, stands and is pressed: problems whose end is at rest.
#include "report/clock.h"
#include "report/contact/problems.h"
#include "support/hertz.h"
#include "support/rig.h"

namespace incision::report {
namespace {

constexpr double DENSITY = 1000, STIFF = 1e6, SOFT = 1e5;  // [kg/m³], [Pa]
constexpr double LONG_STEP = 0.01, SHORT_STEP = 0.0025;    // [s]
constexpr double DURATION = 2;                             // until what swings has come to rest [s]
constexpr double RAMP = 0.5;                               // of loads [s], longer than anything swings
constexpr double FRICTION = 0.3;
constexpr double PRESSURE = 1000, LAYER_HEIGHT = 0.1;  // [Pa], [m]
const Vec3 COLUMN(0.1, 0.1, 0.3);                      // [m]

Scene onTheGround(const std::array<int, 3>& cells, const Vec3& size) {
  Scene scene;
  scene.body.grid = GridSettings{cells, size, Vec3::Zero()};
  scene.body.material = {STIFF, 0, DENSITY, 0, 2e-3};  // ν = 0: nothing widens, so the answers are exact
  scene.contact = ContactSettings();
  scene.contact->ground = 0;
  scene.contact->friction = FRICTION;
  return scene;
}

/// Takes the steps until it rests, and then the value.
template <typename Value>
ContactRun restOf(Scene scene, int across, double time_step, const Value& value) {
  scene.solver.time_step = time_step;
  const TetMesh mesh = loadMesh(scene);
  const Clock clock;
  DeformableBody body(scene, mesh);
  for (int k = 0; k < std::lround(DURATION / time_step); ++k) body.step();
  const double ms = clock.ms();
  return {static_cast<int>(mesh.elements.size()), across, time_step, ms, value(body),
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

namespace {

/// With its length of steps.
std::string named(const std::string& what, double time_step) {
  return what + "steps of " + (time_step == LONG_STEP ? "10 ms" : "2.5 ms");
}

// Tractions on all sides but the lowest are those of a uniform stress, so the strain is uniform too.
ContactRun holdLayer(int cells, double time_step, double shear) {
  const double length = 0.4, height = LAYER_HEIGHT;
  Scene scene = onTheGround({4 * cells, 4 * cells, cells}, Vec3(length, length, height));
  scene.gravity.setZero();
  scene.body.material.young_modulus = SOFT;
  scene.loads = {{slab(2, height), Vec3(shear, 0, -PRESSURE), RAMP}};
  for (const double x : {0.0, length}) scene.loads.push_back({slab(0, x), Vec3(0, 0, x > 0 ? shear : -shear), RAMP});
  return restOf(scene, cells, time_step, [&](const DeformableBody& body) {
    return meanDisplacement(body, height).x() - meanDisplacement(body, 0).x();
  });
}

ContactRun standColumn(int cells, double time_step, bool cut) {
  Scene scene = onTheGround({cells, cells, 3 * cells}, COLUMN);
  if (cut)
    for (const double z : {0.107, 0.211}) scene.cuts.push_back({0, plane(Vec3(0, 0, z), Vec3::UnitZ())});
  return restOf(scene, cells, time_step,
                [&](const DeformableBody& body) { return -meanDisplacement(body, COLUMN.z()).z(); });
}

}  // namespace

ContactProblem heldLayer(bool quick) {
  const double shear = 0.8 * FRICTION * PRESSURE;
  ContactProblem problem = {"layer held by friction", "shear of its top", {}};
  for (const double time_step : {LONG_STEP, SHORT_STEP}) {
    ContactCurve curve = {named("", time_step), shear * LAYER_HEIGHT / (SOFT / 2), {}};
    for (int cells = 1; cells <= (quick ? 2 : 4); ++cells) curve.runs.push_back(holdLayer(cells, time_step, shear));
    problem.curves.push_back(curve);
  }
  return problem;
}

ContactProblem stack(bool quick) {
  ContactProblem problem = {"column of three pieces", "how far its top sinks", {}};
  for (const bool cut : {false, true})
    for (const double time_step : {LONG_STEP, SHORT_STEP}) {
      if (!cut && time_step == SHORT_STEP) continue;
      ContactCurve curve = {
          named(cut ? "cut, " : "whole, ", time_step), DENSITY * G * COLUMN.z() * COLUMN.z() / (2 * STIFF), {}};
      for (const int cells : quick ? std::vector<int>{2, 3} : std::vector<int>{2, 3, 4, 6})
        curve.runs.push_back(standColumn(cells, time_step, cut));
      problem.curves.push_back(curve);
    }
  return problem;
}

}  // namespace incision::report
