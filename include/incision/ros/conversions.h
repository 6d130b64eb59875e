#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Vector3.h>
#include <incision/BodyState.h>
#include <incision/CrackEvent.h>
#include <incision/CutPlane.h>
#include <incision/CutReport.h>

#include "incision/body/deformable_body.h"
#include "incision/body/quantities.h"
#include "incision/body/stress_view.h"
#include "incision/pace/command.h"

namespace incision {

Vec3 toVec3(const geometry_msgs::Point& p);
Vec3 toVec3(const geometry_msgs::Vector3& v);
geometry_msgs::Point toPoint(const Vec3& v);
geometry_msgs::Vector3 toVector3(const Vec3& v);

/// What the message says, in its own frame; nothing is checked.
PlaneCut toPlaneCut(const CutPlane& message);

/// The quaternion is normalised, and nothing is checked.
Pose toPose(const geometry_msgs::Pose& pose);
Pose toPose(const geometry_msgs::Transform& transform);

geometry_msgs::Pose toPoseMessage(const Pose& pose);

/// Throws std::runtime_error where a ros::Time cannot be that late.
ros::Time toRos(Nanoseconds stamp);

/// All but the header.
CutReport toReport(const CutResult& result);
CrackEvent toEvent(const CrackResult& result);

/// Fills the fields of these names.
void fillState(const std::vector<Quantity>& quantities, BodyState* state);

/// Fills the lists of regions; their stress is empty before it is first found.
void fillRegions(const Regions& regions, const std::vector<RegionStress>& stress, BodyState* state);

}  // namespace incision
