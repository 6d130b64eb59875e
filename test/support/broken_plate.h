#pragma once

#include "support/blade.h"
#include "support/tool.h"

namespace incision::test {

/// A plate on the ground, broken in pieces that rub against each other, while a blade cuts it against resistance.
inline Scene everythingAtOnce(Method method) {
  Scene scene = plateAndBlade();
  scene.gravity = Vec3(0, 0, -9.81);
  scene.solver.method = method;
  scene.solver.tolerance = 1e-9;
  scene.contact = ContactSettings();
  scene.contact->ground = -0.001;
  bladeOf(&scene.tools[0]).cutting.resistance.force = 20;
  for (int k = 0; k <= 40; ++k)
    scene.tools[0].poses.push_back({0.01 * k, {Vec3(-0.05 + 0.02 * k, 0.21, 0), Eigen::Quaterniond::Identity()}});
  PlaneCut plane;
  plane.point = Vec3(0.6, 0.2, 0.1);
  plane.normal = Vec3(1, 0.3, 0.2);
  scene.cuts = {{0.05, plane}};
  scene.fracture = FractureSettings();
  scene.fracture->tensile_strength = 300;
  scene.fracture->fracture_energy = 1;
  return scene;
}

}  // namespace incision::test
