#include "incision/contact/obstacles.h"

#include "incision/base/input_error.h"
#include "incision/base/printable.h"
#include "incision/rigid/description.h"
#include "incision/rigid/half_space.h"

namespace incision {

namespace {

void addLink(const DescribedLink& link, const std::string& where, Obstacles* obstacles) {
  if (!link.fault.empty()) throw InputError(where + ": " + link.fault);
  if (link.solids.empty()) return;
  checkPose(link.pose, where);
  const int index = static_cast<int>(obstacles->links.size());
  obstacles->links.push_back({link.name, link.pose});
  for (const DescribedSolid& described : link.solids) {
    checkSolid(described, where);
    obstacles->shapes.push_back({described.solid, described.pose, index});
  }
}

void checkCount(std::size_t count, const std::string& name) {
  if (count > 0 && count <= MAX_OBSTACLES) return;
  throw InputError(name + ": " + std::to_string(count) + " collision shapes (allowed: 1 to " +
                   std::to_string(MAX_OBSTACLES) + ")");
}

Obstacle groundAt(double height) {
  Obstacle ground;
  ground.solid = std::make_shared<HalfSpace>();
  ground.pose.position.z() = height;
  return ground;
}

}  // namespace

Obstacles loadObstacles(const ContactSettings& settings, const std::string& urdf, const std::string& name) {
  Obstacles obstacles;
  if (!settings.obstacles.empty()) {
    for (const DescribedLink& link : parseDescription(urdf, name).links)
      addLink(link, linkInMessage(name, link.name), &obstacles);
    checkCount(obstacles.shapes.size(), name);
  }
  if (settings.ground) obstacles.shapes.push_back(groundAt(*settings.ground));
  return obstacles;
}

Obstacles loadLink(const Description& description, const std::string& link) {
  Obstacles obstacles;
  addLink(description.link(link), linkInMessage(description.name, link), &obstacles);
  if (!obstacles.shapes.empty()) checkCount(obstacles.shapes.size(), description.name);
  return obstacles;
}

std::vector<std::string> remarksOn(const Obstacles& obstacles) {
  std::vector<std::string> remarks;
  for (const Obstacle& shape : obstacles.shapes) {
    const std::string remark = shape.solid->remark();
    if (remark.empty()) continue;
    const auto link = static_cast<std::size_t>(shape.link);  // the ground's is beyond all
    const std::string name = link < obstacles.links.size() ? obstacles.links[link].name : "";
    remarks.push_back((name.empty() ? "" : "link '" + printable(name) + "': ") + remark);
  }
  return remarks;
}

}  // namespace incision
