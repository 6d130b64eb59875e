#include "incision/contact/obstacles.h"

#include "incision/base/input_error.h"
#include "incision/rigid/description.h"

namespace incision {

namespace {

void checkObstacle(const DescribedShape& shape, const std::string& where) {
  if (shape.is_mesh) throw InputError(where + ": a mesh as collision shape (allowed: sphere, box, cylinder)");
  checkShape(shape, where);
}

void addLink(const DescribedLink& link, const std::string& where, Obstacles* obstacles) {
  if (!link.fault.empty()) throw InputError(where + ": " + link.fault);
  if (link.shapes.empty()) return;
  checkPose(link.pose, where);
  const int index = static_cast<int>(obstacles->links.size());
  obstacles->links.push_back({link.name, link.pose});
  for (const DescribedShape& shape : link.shapes) {
    checkObstacle(shape, where);
    obstacles->shapes.push_back({shape.shape, shape.pose, index});
  }
}

void checkCount(std::size_t count, const std::string& name) {
  if (count > 0 && count <= MAX_OBSTACLES) return;
  throw InputError(name + ": " + std::to_string(count) + " collision shapes (allowed: 1 to " +
                   std::to_string(MAX_OBSTACLES) + ")");
}

Obstacle groundAt(double height) {
  Obstacle ground;
  ground.pose.position.z() = height;
  return ground;
}

}  // namespace

Obstacles loadObstacles(const ContactSettings& settings, const std::string& urdf, const std::string& name) {
  Obstacles obstacles;
  if (!settings.obstacles.empty()) {
    for (const DescribedLink& link : parseDescription(urdf, name))
      addLink(link, linkInMessage(name, link.name), &obstacles);
    checkCount(obstacles.shapes.size(), name);
  }
  if (settings.ground) obstacles.shapes.push_back(groundAt(*settings.ground));
  return obstacles;
}

Obstacles loadLink(const std::string& link, const std::string& urdf, const std::string& name) {
  Obstacles obstacles;
  const std::vector<DescribedLink> links = parseDescription(urdf, name);
  addLink(findLink(links, link, name), linkInMessage(name, link), &obstacles);
  if (!obstacles.shapes.empty()) checkCount(obstacles.shapes.size(), name);
  return obstacles;
}

}  // namespace incision
