#include <iostream>

#include "benchmark/bullet_body.h"
#include "benchmark/groups.h"
#include "benchmark/plain_reference.h"
#include "benchmark/rounds.h"
#include "benchmark/scenes.h"
#include "incision/body/deformable_body.h"

namespace incision::bench {
namespace {

constexpr int STEPS = 200;

/// Where SOFA and Vega FEM have node (1, 0.125, 0.125) of the bar 16×4×4 after these steps, from its rest position [m].
const Vec3 EXPECTED(-0.009565, -0.032256, -0.126242);

/// What ours and the plain reference may differ from it [m]: the six digits given, and their own rounding.
constexpr double ALLOWED = 2e-6;

/// The node in the middle of the far end: (i (ny + 1) + j)(nz + 1) + k with i = nx, j = ny/2, k = nz/2.
constexpr int TIP = (SMALL[0] * (SMALL[1] + 1) + SMALL[1] / 2) * (SMALL[2] + 1) + SMALL[2] / 2;

template <typename Body>
Json tipOf(Body* body, const TetMesh& mesh) {
  for (int k = 0; k < STEPS; ++k) body->step();
  const Vec3 u = body->nodePositions()[TIP] - mesh.nodes[TIP];
  return {{"x", u.x()}, {"y", u.y()}, {"z", u.z()}, {"off", (u - EXPECTED).norm()}};
}

template <typename Peer>
Json peerTip() {
  const Scene scene = bar(SMALL);
  const TetMesh mesh = loadMesh(scene);
  Peer peer(scene, mesh);
  return tipOf(&peer, mesh);
}

Json ourTip(Method method, double tolerance) {
  Scene scene = bar(SMALL);
  scene.solver.method = method;
  scene.solver.tolerance = tolerance;
  const TetMesh mesh = loadMesh(scene);
  DeformableBody body(scene, mesh);
  return tipOf(&body, mesh);
}

}  // namespace

bool tips(const Options&, Json* rows) {
  const Table table(
      "Tip of the bar " + nameOf(SMALL) + " after 200 steps [m]; SOFA and Vega: -0.009565 -0.032256 -0.126242",
      {{"x", "/x", 6}, {"y", "/y", 6}, {"z", "/z", 6}, {"off", "/off", 7}});
  const std::vector<Run> exact = {{"iterative, 1e-9", [] { return ourTip(Method::ITERATIVE, 1e-9); }},
                                  {"direct", [] { return ourTip(Method::DIRECT, 1e-9); }},
                                  {"plain CHOLMOD", peerTip<PlainReference>}};
  const std::vector<Run> close = {{"iterative, 1e-4", [] { return ourTip(Method::ITERATIVE, 1e-4); }},
                                  {"Bullet", peerTip<BulletBody>}};
  const auto measure = [&](const std::vector<Run>& runs) {
    double worst = 0;
    for (Json row : bestOfRounds(runs, 1, "/off")) {
      row["scene"] = "tips";
      table.print(row);
      rows->push_back(row);
      worst = std::max(worst, row["off"].get<double>());
    }
    return worst;
  };
  const bool same = measure(exact) <= ALLOWED;
  measure(close);
  if (!same) std::cout << "    FAILED: one of the first three is off by more than " << ALLOWED << " m\n";
  return same;
}

}  // namespace incision::bench
