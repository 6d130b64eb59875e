#include "mesh_files.h"

#include <filesystem>
#include <memory>

#include "incision/rigid/mesh_file.h"

namespace incision {

MeshFiles::MeshFiles(const std::string& description) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(description, unknown)) return;
  folder_ = std::filesystem::absolute(description, unknown).parent_path().string();
}

SolidPtr MeshFiles::at(const std::string& address, const Vec3& scale, const std::string& where) {
  SolidPtr& mesh = meshes_[{address, {scale.x(), scale.y(), scale.z()}}];
  if (!mesh) mesh = std::make_shared<MeshFile>(address, folder_, scale, where);
  return mesh;
}

}  // namespace incision
