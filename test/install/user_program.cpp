// Every installed header, in one list that the test writes, and a body that is cut.
#include "installed_headers.h"

int main() {
  incision::Scene scene;
  scene.body.grid.emplace();
  incision::DeformableBody body(scene, incision::loadMesh(scene));
  incision::PlaneCut cut;
  cut.point = {0.45, 0, 0};
  cut.normal = incision::Vec3::UnitX();
  const bool applied = body.cut(cut).status == incision::CutStatus::APPLIED;
  body.step();
  return applied && body.steps() == 1 ? 0 : 1;
}
