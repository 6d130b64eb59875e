#include "report/static/gmsh.h"

#include <stdlib.h>

#include "incision/mesh/mesh_io.h"
#include "report/static/clock.h"

namespace incision::report {

Gmsh::Gmsh() {
  std::string folder = (std::filesystem::temp_directory_path() / "incision_XXXXXX").string();
  if (!mkdtemp(folder.data())) throw InputError(folder + ": cannot be made");
  folder_ = folder;
}

Gmsh::~Gmsh() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

const Gmsh::Made& Gmsh::mesh(const std::string& geometry, int cells, bool faces) {
  const std::string file = (folder_ / "body.msh").string();
  const std::string command = "gmsh -3 -format msh22 -v 1 '" INCISION_SOURCE_DIR "/test/report/static/" + geometry +
                              "' -setnumber cells " + std::to_string(cells) + " -setnumber faces " +
                              std::to_string(faces) + " -o '" + file + "' >/dev/null";
  const auto known = made_.find(command);
  if (known != made_.end()) return known->second;
  const Clock clock;
  if (std::system(command.c_str()) != 0) throw InputError("this command failed: " + command);
  TetMesh mesh = readGmsh(file);
  return made_[command] = {std::move(mesh), clock.ms()};
}

}  // namespace incision::report
