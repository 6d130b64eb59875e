#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "incision/body/deformable_body.h"

namespace incision::report {

/// Of gravity [m/s²].
inline const double G = -Scene().gravity.z();

/// One run of a problem.
struct ContactRun {
  int elements;
  int across;        ///< elements across what is looked at
  double time_step;  ///< [s]
  double ms;         ///< wall time of the whole job on a mesh in memory
  double value;
  int unsettled = 0;  ///< steps in which the forces of contacts did not settle
};

/// How a problem is solved on finer and finer meshes or in shorter and shorter steps.
struct ContactCurve {
  std::string name;
  double answer;  ///< in closed form; where there is none, that of a still finer run
  std::vector<ContactRun> runs;
};

/// A problem in which bodies touch.
struct ContactProblem {
  std::string name, quantity;
  std::vector<ContactCurve> curves;
};

nlohmann::json toJson(const ContactProblem& problem);

/// A sphere pressed into a block, on finer meshes.
ContactProblem hertz(bool quick);

/// A layer that lies on the ground and is pulled sideways by less than friction can bear: how far its top moves.
ContactProblem heldLayer(bool quick);

/// A block that slides: how far, with either solver, in shorter steps.
ContactProblem slidingBlock(bool quick);

/// A column that stands on the ground, whole and cut into three: how far it sinks under its weight.
ContactProblem stack(bool quick);

/// A slit bar whose two leaves beat on each other as it swings: in shorter steps, and on finer meshes. It has no answer
/// but that of the finest.
ContactProblem slitBar(bool quick);

/// The mean displacement [m] of the nodes at a height, and of those alone that lie at an x where one is given.
Vec3 meanDisplacement(const DeformableBody& body, double z, std::optional<double> x = std::nullopt);

}  // namespace incision::report
