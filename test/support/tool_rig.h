#pragma once

#include <string>

#include "incision/contact/contact.h"
#include "support/rig.h"

namespace incision {

/// A link "blade" with one collision shape, such as "<sphere radius='1'/>", at `xyz`.
inline std::string toolUrdf(const std::string& shape, const std::string& xyz = "0 0 0") {
  return "<robot name='tool'><link name='blade'><collision><origin xyz='" + xyz + "'/><geometry>" + shape +
         "</geometry></collision></link></robot>";
}

/// An edge that is far from every shape of these tests.
inline const Edge FAR_EDGE = {Vec3(0, 0, 100), Vec3(0, 0, 101)};

/// A body and a tool that pushes it.
struct ToolRig : Rig {
  ToolRig(TetMesh rest, const RigSettings& settings, const ContactSettings& touching, const std::string& urdf,
          double friction, const Edge& edge = FAR_EDGE)
      : Rig(std::move(rest), settings),
        contact(touching, obstaclesWith({"blade", friction, edge}, touching, urdf), settings.material.young_modulus, 1),
        tool(contact.obstacles().tool_link) {
    for (const ObstacleLink& link : contact.obstacles().links) links.to.push_back(link.pose);
    links.from = links.to;
    surfaceChanged();
  }

  static Obstacles obstaclesWith(const ToolBody& tool, const ContactSettings& touching, const std::string& urdf) {
    Obstacles obstacles = loadObstacles(touching, "", "");
    addTool(tool, urdf, "tool.urdf", &obstacles);
    return obstacles;
  }

  void surfaceChanged() {
    surface = buildSurface(mesh);
    contact.surfaceChanged(surface, mesh, step.pieceOf());
  }

  void place(const Pose& pose) {
    links.from[tool] = links.to[tool] = pose;
    links.has_tool = true;
  }

  /// Takes a step in which the tool goes to `pose`.
  ContactReport moveTo(const Pose& pose) {
    links.to[tool] = pose;
    contact.begin(motion, time_step, links);
    const auto couple = [&](double dt, const std::vector<Vec3>& v_end, std::vector<Coupling>* couplings) {
      couplings->clear();
      return contact.update(dt, v_end, couplings);
    };
    EXPECT_TRUE(step.advance(time, time_step, &motion, couple));
    time += time_step;
    links.from = links.to;
    return contact.accept(time_step, motion.v);
  }

  const Wrench& onTool() const { return step.onTool(); }

  Surface surface;
  Contact contact;
  LinkMotion links;
  int tool;
};

inline Pose at(const Vec3& position) {
  Pose pose;
  pose.position = position;
  return pose;
}

}  // namespace incision
