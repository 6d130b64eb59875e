#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "incision/contact/settings.h"
#include "incision/cut/crack.h"
#include "incision/fem/boundary.h"
#include "incision/fem/mass.h"
#include "incision/fem/material.h"
#include "incision/fem/pressure.h"
#include "incision/fracture/settings.h"
#include "incision/mesh/grid_mesh.h"
#include "incision/mesh/mesh_io.h"
#include "incision/solver/settings.h"
#include "incision/tool/settings.h"

namespace YAML {
class Node;
}

namespace incision {

struct BodySettings {
  std::string mesh;                  ///< absolute path of a file; or
  std::optional<GridSettings> grid;  ///< exactly one of the two is given
  std::string frame = "body";        ///< tf frame of the body's coordinates
  Material material;
  bool warping = true;
  Mass mass = Mass::LUMPED;
  Pressure pressure = Pressure::ELEMENT;
};

/// Longest label of a cut, in bytes of UTF-8: labels go into reports and logs, where a line must stay a line.
inline constexpr std::size_t MAX_LABEL = 64;

struct ScheduledCut {
  double time = 0;  ///< takes effect before the step that starts at the first k Δt ≥ time
  PlaneCut plane;
};

struct Scene {
  BodySettings body;
  Vec3 gravity = Vec3(0, 0, -9.81);  ///< [m/s²]
  std::vector<Hold> boundary;
  std::vector<Load> loads;
  SolverSettings solver;
  std::vector<ScheduledCut> cuts;
  std::optional<FractureSettings> fracture;  ///< absent: it breaks only where it is cut
  std::optional<ContactSettings> contact;    ///< absent: the body touches nothing, not even itself
  std::optional<ToolSettings> tool;
};

/// Reads a scene and checks every value. `source` is the file or parameter errors name; relative paths in the scene are
/// taken from `folder`. Throws InputError with source, key, value and what is allowed.
Scene parseScene(const YAML::Node& root, const std::string& source, const std::string& folder);

/// Reads a scene file; each override "solver.time_step=0.005" or "cuts.0.normal=[1,0,0]" replaces or adds one value
/// first, and the maps on the way to it. Throws InputError.
Scene loadScene(const std::string& path, const std::vector<std::string>& overrides = {});

/// The scene's mesh file or grid.
TetMesh loadMesh(const Scene& scene, MeshRepairs* repairs = nullptr);

/// Texts of URDFs; empty where there is none.
struct Descriptions {
  std::string tool, obstacles;
};

/// Text of the tool's description where the scene's tool needs one to know its edge or what of it touches, else
/// empty.
std::string loadDescription(const Scene& scene);

/// Text of the obstacles' description where the scene names one, else empty.
std::string loadObstacleDescription(const Scene& scene);

}  // namespace incision
