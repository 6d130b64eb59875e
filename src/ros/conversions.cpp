#include "incision/ros/conversions.h"

#include <functional>
#include <map>
#include <stdexcept>
#include <type_traits>
#include <variant>

namespace incision {

Vec3 toVec3(const geometry_msgs::Point& p) { return {p.x, p.y, p.z}; }
Vec3 toVec3(const geometry_msgs::Vector3& v) { return {v.x, v.y, v.z}; }

geometry_msgs::Point toPoint(const Vec3& v) {
  geometry_msgs::Point p;
  p.x = v.x(), p.y = v.y(), p.z = v.z();
  return p;
}

geometry_msgs::Vector3 toVector3(const Vec3& v) {
  geometry_msgs::Vector3 w;
  w.x = v.x(), w.y = v.y(), w.z = v.z();
  return w;
}

PlaneCut toPlaneCut(const CutPlane& message) {
  PlaneCut plane;
  plane.label = message.label;
  plane.point = toVec3(message.point);
  plane.normal = toVec3(message.normal);
  plane.tangent = toVec3(message.tangent);
  plane.length = message.length;
  plane.width = message.width;
  return plane;
}

namespace {

Eigen::Quaterniond toQuaternion(const geometry_msgs::Quaternion& q) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized();
}

}  // namespace

Pose toPose(const geometry_msgs::Pose& pose) { return {toVec3(pose.position), toQuaternion(pose.orientation)}; }

Pose toPose(const geometry_msgs::Transform& transform) {
  return {toVec3(transform.translation), toQuaternion(transform.rotation)};
}

geometry_msgs::Pose toPoseMessage(const Pose& pose) {
  geometry_msgs::Pose message;
  message.position = toPoint(pose.position);
  const Eigen::Quaterniond& q = pose.orientation;
  message.orientation.x = q.x(), message.orientation.y = q.y(), message.orientation.z = q.z();
  message.orientation.w = q.w();
  return message;
}

ros::Time toRos(Nanoseconds stamp) { return ros::Time().fromNSec(static_cast<std::uint64_t>(stamp)); }

CutReport toReport(const CutResult& result) {
  CutReport report;
  report.label = result.label;
  report.status = static_cast<std::uint8_t>(result.status);
  report.reason = result.reason;
  report.cracks = result.cracks;
  report.parts_split = result.parts_split;
  report.copies_added = result.copies_added;
  report.pieces = result.pieces;
  report.duration = result.duration;
  return report;
}

CrackEvent toEvent(const CrackResult& result) {
  CrackEvent event;
  event.time = result.time;
  event.crack = result.crack;
  event.change = static_cast<std::uint8_t>(result.change);
  event.other = result.other;
  event.elements = static_cast<std::uint32_t>(result.elements.size());
  event.where = toPoint(result.where);
  event.normal = toVector3(result.normal);
  event.kind = static_cast<std::uint8_t>(result.kind);
  event.stress = result.stress;
  return event;
}

namespace {

template <typename Field, typename Value>
void assign(const Value& value, Field* field) {
  if constexpr (std::is_arithmetic_v<Field> && std::is_arithmetic_v<Value>)
    *field = static_cast<Field>(value);
  else if constexpr (!std::is_arithmetic_v<Field> && !std::is_arithmetic_v<Value>)
    *field = toVector3(value);
  else
    throw std::logic_error("a quantity has another type than its field of the state");
}

using Setter = std::function<void(const Quantity&, BodyState*)>;

template <typename Field>
Setter into(Field BodyState::*field) {
  return [field](const Quantity& quantity, BodyState* state) {
    std::visit([&](const auto& value) { assign(value, &(state->*field)); }, quantity.value);
  };
}

/// Where each quantity goes.
const std::map<std::string, Setter> FIELDS = {{"nodes", into(&BodyState::nodes)},
                                              {"held_nodes", into(&BodyState::held_nodes)},
                                              {"elements", into(&BodyState::elements)},
                                              {"crack_elements", into(&BodyState::crack_elements)},
                                              {"parts", into(&BodyState::parts)},
                                              {"copies", into(&BodyState::copies)},
                                              {"dofs", into(&BodyState::dofs)},
                                              {"cracks", into(&BodyState::cracks)},
                                              {"pieces", into(&BodyState::pieces)},
                                              {"mass", into(&BodyState::mass)},
                                              {"momentum", into(&BodyState::momentum)},
                                              {"kinetic_energy", into(&BodyState::kinetic_energy)},
                                              {"elastic_energy", into(&BodyState::elastic_energy)},
                                              {"max_displacement", into(&BodyState::max_displacement)},
                                              {"iterations", into(&BodyState::iterations)},
                                              {"residual", into(&BodyState::residual)},
                                              {"potential_energy", into(&BodyState::potential_energy)},
                                              {"contact_energy", into(&BodyState::contact_energy)},
                                              {"solves", into(&BodyState::solves)},
                                              {"unsettled_steps", into(&BodyState::unsettled_steps)}};

}  // namespace

void fillState(const std::vector<Quantity>& quantities, BodyState* state) {
  for (const Quantity& quantity : quantities) FIELDS.at(quantity.name)(quantity, state);
}

void fillRegions(const Regions& regions, const std::vector<RegionStress>& stress, BodyState* state) {
  for (int r = 0; r < static_cast<int>(stress.size()); ++r) {
    state->regions.push_back(regions.name(r));
    state->region_mean_stress.push_back(stress[static_cast<std::size_t>(r)].mean);
    state->region_largest_stress.push_back(stress[static_cast<std::size_t>(r)].largest);
  }
}

}  // namespace incision
