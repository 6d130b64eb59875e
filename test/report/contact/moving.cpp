// What slides and swings.
#include "report/clock.h"
#include "report/contact/problems.h"
#include "support/contacts.h"
#include "support/rig.h"

namespace incision::report {
namespace {

/// On how fine a mesh and in how short steps.
struct Fineness {
  int cells;
  double time_step;
};

}  // namespace

// Gravity leans over when the block has come to rest, and its share along the ground is twice what friction bears.
ContactProblem slidingBlock(bool quick) {
  const double friction = 0.4, duration = 0.5, settling = 1;
  ContactProblem problem = {"block that slides", "way", {}};
  for (const Method method : {Method::DIRECT, Method::ITERATIVE}) {
    ContactCurve& curve = problem.curves.emplace_back();
    curve.name = method == Method::DIRECT ? "direct" : "iterative";
    curve.answer = 0.5 * friction * G * duration * duration;
    for (double time_step = 0.02; time_step > (quick ? 4e-3 : 1e-3); time_step /= 2) {
      Scene scene = test::blockAbove(0, {4, 4, 2}, Vec3::Zero());
      scene.body.material.young_modulus = 1e7;  // waves of shear take 2 ms through it
      scene.solver.method = method;
      scene.solver.time_step = time_step;
      scene.contact->friction = friction;
      const TetMesh mesh = loadMesh(scene);
      const Clock clock;
      DeformableBody body(scene, mesh);
      for (int k = 0; k < settling / time_step; ++k) body.step();
      const double start = test::centreOfMass(body).x();
      LiveSettings live = body.live();
      live.gravity.x() = 2 * friction * G;
      body.set(live);
      for (int k = 0; k < std::lround(duration / time_step); ++k) body.step();
      curve.runs.push_back({static_cast<int>(mesh.elements.size()), 4, time_step, clock.ms(),
                            test::centreOfMass(body).x() - start, static_cast<int>(body.unsettledSteps())});
    }
  }
  return problem;
}

namespace {

/// A bar held at one end, slit along its middle from the other to a quarter of its length, that falls under its weight.
ContactRun swing(const Fineness& fineness) {
  const double duration = 0.3, length = 1, height = 0.25;
  Scene scene;
  scene.body.grid =
      GridSettings{{4 * fineness.cells, fineness.cells, fineness.cells}, Vec3(length, height, height), Vec3(0, 0, 0)};
  scene.body.material = {2e5, 0.3, 1000, 0, 0};
  scene.boundary = {{slab(0, 0), Vec3::Zero()}};
  scene.cuts = {{0, rectangle(Vec3(length, height / 2, height / 2), Vec3::UnitZ(), Vec3::UnitX(), 1.5 * length, 1)}};
  scene.contact = ContactSettings();
  scene.solver.time_step = fineness.time_step;
  const TetMesh mesh = loadMesh(scene);
  const Clock clock;
  DeformableBody body(scene, mesh);
  for (int k = 0; k < std::lround(duration / fineness.time_step); ++k) body.step();
  return {static_cast<int>(mesh.elements.size()),
          fineness.cells,
          fineness.time_step,
          clock.ms(),
          -meanDisplacement(body, 0, length).z(),
          static_cast<int>(body.unsettledSteps())};
}

/// The last one is what the others are held against.
ContactCurve curveOf(const std::string& name, const std::vector<Fineness>& list) {
  ContactCurve curve = {name, 0, {}};
  for (const Fineness& fineness : list) curve.runs.push_back(swing(fineness));
  curve.answer = curve.runs.back().value;
  curve.runs.pop_back();
  return curve;
}

}  // namespace

ContactProblem slitBar(bool quick) {
  std::vector<Fineness> shorter, finer;
  for (const double time_step : {0.02, 0.01, 0.005, 0.0025, 0.00125})
    if (!quick || time_step > 0.003) shorter.push_back({5, time_step});
  shorter.push_back({5, shorter.back().time_step / 4});
  for (const int cells : {3, 5, 7, 9, 13})
    if (!quick || cells < 9) finer.push_back({cells, 0.005});
  return {"slit bar that beats on itself",
          "how far its end falls",
          {curveOf("shorter steps", shorter), curveOf("finer meshes", finer)}};
}

}  // namespace incision::report
