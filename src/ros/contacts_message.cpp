#include "incision/ros/contacts_message.h"

#include "incision/ros/conversions.h"

namespace incision {
namespace {

constexpr const char* GROUND = "ground";
constexpr const char* SELF = "self";

std::string nameOf(const ContactPoint& point, const ContactNames& names) {
  if (point.tool >= 0) return names.tools[static_cast<std::size_t>(point.tool)];
  return point.partner < 0 ? SELF : names.shapes[static_cast<std::size_t>(point.partner)];
}

}  // namespace

ContactNames contactNames(const Obstacles& obstacles, const std::vector<std::string>& tools) {
  ContactNames names;
  names.tools = tools;
  for (const ObstacleLink& link : obstacles.links) names.links.push_back(link.name);
  for (const Obstacle& shape : obstacles.shapes) {
    const bool is_ground = shape.link == GROUND_LINK;
    names.has_ground = names.has_ground || is_ground;
    names.shapes.push_back(is_ground ? GROUND : names.links[static_cast<std::size_t>(shape.link)]);
  }
  return names;
}

Contacts toContacts(const BodyWrenches& wrenches, const ContactNames& names) {
  Contacts message;
  for (const ContactPoint& point : wrenches.points) {
    message.points.push_back(toPoint(point.point));
    message.normals.push_back(toVector3(point.normal));
    message.forces.push_back(toVector3(point.force));
    message.depths.push_back(point.depth);
    message.partners.push_back(nameOf(point, names));
  }
  const auto add = [&](const std::string& name, const Wrench& wrench) {
    geometry_msgs::Wrench felt;
    felt.force = toVector3(wrench.force);
    felt.torque = toVector3(wrench.torque);
    message.bearers.push_back(name);
    message.wrenches.push_back(felt);
  };
  if (names.has_ground) add(GROUND, wrenches.ground);
  for (std::size_t i = 0; i < wrenches.obstacles.size(); ++i) add(names.links[i], wrenches.obstacles[i]);
  for (std::size_t i = 0; i < wrenches.clamps.size(); ++i) add("clamp_" + std::to_string(i), wrenches.clamps[i]);
  return message;
}

}  // namespace incision
