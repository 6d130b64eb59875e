#pragma once

#include <string>

#include "incision/rigid/jaw_links.h"
#include "incision/scene/scene.h"

namespace incision::test {

/// Forceps of boxes: a palm at x < 0 and two jaws of LENGTH along x, WIDTH across y, their insides GAP/2 from z = 0
/// while the angle is 0. `scale` makes them larger as a whole.
struct ForcepsForm {
  double scale = 1;
  double length() const { return 0.02 * scale; }
  double width() const { return 0.006 * scale; }
  double thickness() const { return 0.002 * scale; }
  double gap() const { return 0.001 * scale; }
};

/// One or two of whose jaws move, on a pivot at the origin or sliding along z: a URDF.
inline std::string forcepsUrdf(const ForcepsForm& form, bool both = true, const std::string& type = "revolute") {
  const auto box = [&](double x, double z, double length, double height) {
    const auto text = [](double a, double b, double c) {
      return "'" + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "'";
    };
    return "<collision><origin xyz=" + text(x, 0, z) + "/><geometry><box size=" + text(length, form.width(), height) +
           "/></geometry></collision>";
  };
  const double inside = (form.gap() + form.thickness()) / 2;
  const std::string axis = type == "prismatic" ? "0 0 1" : "0 -1 0";
  const auto joint = [&](const std::string& name, const std::string& child, const std::string& of) {
    return "<joint name='" + name + "' type='" + of + "'><parent link='palm'/><child link='" + child +
           "'/><axis xyz='" + axis + "'/><limit lower='-1' upper='1' effort='1' velocity='1'/>";
  };
  return "<robot name='forceps'><link name='palm'>" +
         box(-1.1 * form.length(), 0, 1.8 * form.length(), 4 * form.thickness()) + "</link><link name='upper'>" +
         box(form.length() / 2, inside, form.length(), form.thickness()) + "</link><link name='lower'>" +
         box(form.length() / 2, -inside, form.length(), form.thickness()) + "</link>" + joint("jaw", "upper", type) +
         "</joint>" + joint("lower_joint", "lower", both ? type : "fixed") +
         (both ? "<mimic joint='jaw' multiplier='-1'/>" : "") + "</joint></robot>";
}

inline JawLinks forceps(const ForcepsForm& form = {}, bool both = true, const std::string& type = "revolute") {
  return JawLinks(parseDescription(forcepsUrdf(form, both, type), "forceps.urdf"), "palm", "jaw");
}

/// Angles of the joint, the mass of the slab below [kg] and gravity on it [m/s²].
inline constexpr double FORCEPS_OPEN = 0.5, FORCEPS_CLOSED = 0.05, SLAB_MASS = 2.4e-3, SLAB_GRAVITY = 9.81;

/// The lower edge of the slab below.
inline const Clamp SLAB_END = {Place(Vec3(0.04 - 1e-6, -1, -1), Vec3(1, 1, 1)), Vec3::Zero()};

/// Forceps with which a scene has its tissue held.
inline ToolSettings graspingTool(const std::string& name, double grip) {
  ToolSettings tool;
  tool.name = name;
  tool.description = "forceps.urdf";
  tool.link = "palm";
  tool.kind = GrasperSettings{FORCEPS_CLOSED, grip};
  tool.jaw.emplace().joint = "jaw";
  return tool;
}

/// A slab 40 × 20 × 3 mm round z = 0, its upper edge at x = 0, and graspers of so much strength; x points down.
inline Scene slabAndForceps(double grip, bool touching, int tools = 1) {
  Scene scene;
  scene.body.grid = GridSettings{{8, 4, 1}, Vec3(0.04, 0.02, 0.003), Vec3(0, -0.01, -0.0015)};
  scene.body.material = {3e4, 0.3, 1000, 10, 2e-3};
  scene.solver = {0.005, Method::DIRECT, 1e-10, 1};
  scene.gravity = Vec3(SLAB_GRAVITY, 0, 0);
  if (touching) scene.contact = ContactSettings();
  for (int i = 0; i < tools; ++i) scene.tools.push_back(graspingTool("forceps" + std::to_string(i), grip));
  return scene;
}

inline Pose facingX(double x, double z = 0) { return {Vec3(x, 0, z), Eigen::Quaterniond::Identity()}; }
/// The slab's upper edge lies 12 mm along the jaws.
inline const Pose AT_EDGE = facingX(-0.012);
/// Its edge at y = −0.01 does, below the jaws that hold the upper edge.
inline const Pose AT_SIDE = {Vec3(0.014, -0.022, 0), Eigen::Quaterniond(Eigen::AngleAxisd(M_PI / 2, Vec3::UnitZ()))};

}  // namespace incision::test
