#pragma once

#include <string>

#include "incision/base/read_text.h"
#include "incision/rigid/jaw_links.h"

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

}  // namespace incision::test
