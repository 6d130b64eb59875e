#pragma once

#include <string>

#include "incision/contact/body_contact.h"
#include "incision/tool/tool_contact.h"
#include "support/given_springs.h"

namespace incision {

/// A link "blade" with one collision shape, such as "<sphere radius='1'/>", at `xyz`.
inline std::string toolUrdf(const std::string& shape, const std::string& xyz = "0 0 0") {
  return "<robot name='tool'><link name='blade'><collision><origin xyz='" + xyz + "'/><geometry>" + shape +
         "</geometry></collision></link></robot>";
}

/// The shapes of that link.
inline Obstacles shapesOf(const std::string& urdf) { return loadLink(parseDescription(urdf, "tool.urdf"), "blade"); }

/// An edge that is far from every shape of these tests.
inline const Edge FAR_EDGE = {Vec3(0, 0, 100), Vec3(0, 0, 101)};

/// A body and a tool that pushes it.
struct ToolRig : Rig {
  ToolRig(TetMesh rest, const RigSettings& settings, const ContactSettings& touching, const std::string& urdf,
          double friction, const Edge& edge = FAR_EDGE)
      : Rig(std::move(rest), settings),
        surface(mesh),
        skin(surface, materials, 1),
        obstacles(loadObstacles(touching, "", "")),
        contact(touching, obstacles, motions, &skin),
        tool_contact(0, shapesOf(urdf), friction, edge, &skin),
        couplers({&contact, &tool_contact}) {
    tool_contact.setTool(&tool);
    tool.groups.resize(1);
    tool.felt.resize(1);
  }

  void surfaceChanged() {
    surface.changed();
    couplers.changed(mesh);
  }

  void place(const Pose& pose) {
    tool.groups[0] = {pose, pose};
    tool.in_place = true;
  }

  /// Takes a step in which the tool goes to `pose`.
  ContactReport moveTo(const Pose& pose) {
    tool.groups[0].to = pose;
    tool.felt[0] = Wrench();
    EXPECT_TRUE(advanceWith(this, &couplers));
    tool.groups[0].from = pose;
    ContactReport report = contact.report();
    report.add(tool_contact.report());
    return report;
  }

  const Wrench& onTool() const { return tool.felt[0]; }

  CurrentSurface surface;
  ContactSkin skin;
  Obstacles obstacles;
  std::vector<RigidMotion> motions;  // of the obstacles' links: there are none
  BodyContact contact;
  ToolContact tool_contact;
  ToolInStep tool;
  Couplers couplers;
};

inline Pose at(const Vec3& position) {
  Pose pose;
  pose.position = position;
  return pose;
}

}  // namespace incision
