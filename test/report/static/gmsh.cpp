#include "report/static/gmsh.h"

#include "incision/mesh/mesh_io.h"
#include "report/clock.h"

namespace incision::report {

const Gmsh::Made& Gmsh::mesh(const std::string& geometry, int cells, bool faces) {
  const std::string file = folder_.file("body.msh");
  const std::string command = "gmsh -3 -format msh22 -v 1 '" INCISION_SOURCE_DIR "/test/report/static/" + geometry +
                              "' -setnumber cells " + std::to_string(cells) + " -setnumber faces " +
                              std::to_string(faces) + " -o '" + file + "'";
  const auto known = made_.find(command);
  if (known != made_.end()) return known->second;
  const Clock clock;
  folder_.run(command);
  TetMesh mesh = readGmsh(file);
  return made_[command] = {std::move(mesh), clock.ms()};
}

}  // namespace incision::report
