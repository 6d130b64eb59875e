#pragma once

#include <optional>
#include <string>
#include <vector>

#include "incision/contact/settings.h"
#include "incision/cut/settings.h"
#include "incision/fem/body_settings.h"
#include "incision/fem/boundary_settings.h"
#include "incision/fracture/settings.h"
#include "incision/solver/settings.h"
#include "incision/tool/settings.h"

namespace YAML {
class Node;
}

namespace incision {

/// What a file or a parameter says of a body and of what acts on it. Each section is described beside its parser.
struct Scene {
  BodySettings body;
  Vec3 gravity = Vec3(0, 0, -9.81);  ///< [m/s²]
  std::vector<Clamp> boundary;
  std::vector<Load> loads;
  SolverSettings solver;
  std::vector<ScheduledCut> cuts;
  std::optional<FractureSettings> fracture;  ///< absent: it breaks only where it is cut
  std::optional<ContactSettings> contact;    ///< absent: the body touches nothing, not even itself
  std::vector<ToolSettings> tools;           ///< by name
};

/// Reads a scene and checks every value; files that it names are still to be read. `source` is the file or parameter
/// errors name; relative paths in the scene are taken from `folder`. Throws InputError with source, key, value and what
/// is allowed.
Scene parseScene(const YAML::Node& root, const std::string& source, const std::string& folder);

/// Reads the files of poses and angles that a scene names. Throws InputError.
void loadPoses(Scene* scene);

/// Reads a scene file, and the files of poses that it names; each override "solver.time_step=0.005" or
/// "cuts.0.normal=[1,0,0]" replaces or adds one value first, and the maps on the way to it. Throws InputError.
Scene loadScene(const std::string& path, const std::vector<std::string>& overrides = {});

/// The scene's mesh files or grid. What reading had to mend is added to `notes`, each a sentence.
TetMesh loadMesh(const Scene& scene, std::vector<std::string>* notes = nullptr);

/// Texts of URDFs; empty where there is none.
struct Descriptions {
  std::vector<std::string> tools;  ///< of each of the scene's
  std::string obstacles;
};

/// Texts of the descriptions that the scene names.
Descriptions loadDescriptions(const Scene& scene);

}  // namespace incision
