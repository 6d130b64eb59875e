#include "contact_runs.h"
#include "support/contacts.h"
#include "support/random.h"
#include "support/tool.h"

namespace incision::report {

using test::ELEMENT;

namespace {

/// Of a scene of support/contacts.h, whose body is cut at once.
Scene touchingAs(const Touching& touching, Scene scene) {
  scene.body.material = {touching.young_modulus, 0.3, 1000, 0, 0};
  scene.solver = {touching.time_step, Method::AUTO, 1e-6, 1};
  scene.contact->friction = touching.friction;
  scene.contact->self = touching.self;
  return scene;
}

}  // namespace

Scene fallingBlock(const Touching& touching, double height, unsigned seed) {
  Scene scene = touchingAs(touching, test::fallingToPieces(touching.young_modulus, 3, 4, seed));
  scene.body.grid->origin.z() = height;
  for (ScheduledCut& cut : scene.cuts) cut.plane.point.z() += height;
  return scene;
}

Scene leaningStack(const Touching& touching, unsigned seed) {
  const double above = 0.001, lean = 0.02, tilt = 0.05;
  Scene scene = touchingAs(touching, test::blockAbove(0, {2, 2, 6}, Vec3(0, 0, above)));
  test::Random random(seed);
  const auto leaning = [&](double most) -> Vec3 {
    return Vec3(random.uniform(-most, most), random.uniform(-most, most), 1).normalized();
  };
  scene.gravity = scene.gravity.z() * leaning(lean);
  for (const double z : {0.1, 0.2}) {
    const Vec3 middle(ELEMENT, ELEMENT, z + above + random.uniform(-0.4, 0.4) * ELEMENT);
    scene.cuts.push_back({0, plane(middle, leaning(tilt))});
  }
  return scene;
}

Scene bladeThroughPieces(const Touching& touching, unsigned seed) {
  const double above = 0.001, width = 3 * ELEMENT, room = 0.02, speed = 0.5;
  Scene scene = touchingAs(touching, test::fallingToPieces(touching.young_modulus, 3, 3, seed));
  scene.body.grid->origin.z() = above;
  test::Random random(seed);
  const double z = random.uniform(0.3, 0.7) * width, slope = random.uniform(-0.2, 0.2) * width;
  scene.tools = {bladeTool(Edge{Vec3(0, -width, z - 2 * slope), Vec3(0, 2 * width, z + slope)})};
  scene.tools[0].poses = {{0, {Vec3(-room, 0, 0), Eigen::Quaterniond::Identity()}},
                          {(width + 2 * room) / speed, {Vec3(width + room, 0, 0), Eigen::Quaterniond::Identity()}}};
  return scene;
}

}  // namespace incision::report
