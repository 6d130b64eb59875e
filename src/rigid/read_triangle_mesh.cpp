#include "incision/rigid/read_triangle_mesh.h"

#include <assimp/BaseImporter.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <array>
#include <assimp/Importer.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>

#include "collada_text.h"
#include "incision/base/input_error.h"
#include "incision/base/printable.h"

namespace incision {
namespace {

/// A file system of one file: what a mesh names beside itself, such as its materials, is not there.
class OneFile : public Assimp::IOSystem {
 public:
  OneFile(std::string name, const std::string& bytes) : name_(std::move(name)), bytes_(bytes) {}

  bool Exists(const char* name) const override { return name_ == name; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* name, const char* /*mode*/) override {
    if (!Exists(name)) return nullptr;
    return new Assimp::MemoryIOStream(reinterpret_cast<const uint8_t*>(bytes_.data()), bytes_.size());
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  std::string name_;
  const std::string& bytes_;
};

/// Keeps only the reader for the format, whatever a file looks like.
void keepReader(const std::string& format, Assimp::Importer* importer) {
  const Assimp::BaseImporter* kept = importer->GetImporter(format.c_str());
  for (std::size_t i = importer->GetImporterCount(); i-- > 0;) {
    Assimp::BaseImporter* reader = importer->GetImporter(i);
    if (reader == kept) continue;
    importer->UnregisterLoader(reader);
    delete reader;  // which nobody else does any more
  }
}

/// The library multiplies the count of triangles in 32 bits: with 2³¹ added to a true one it finds the length to be
/// right, makes room for all of them and reads beyond the file's end.
void checkBinaryStl(const std::string& bytes) {
  constexpr std::size_t HEADER = 80, TRIANGLE = 50;
  std::array<unsigned char, 4> digits;  // of 256
  if (bytes.size() < HEADER + digits.size()) return;
  std::memcpy(digits.data(), &bytes[HEADER], digits.size());
  const std::uint32_t count = digits[0] + (digits[1] << 8U) + (digits[2] << 16U) + (std::uint32_t{digits[3]} << 24U);
  const std::size_t expected = HEADER + digits.size() + TRIANGLE * count;
  const bool seems_binary = static_cast<std::uint32_t>(expected) == static_cast<std::uint32_t>(bytes.size());
  if (seems_binary && expected != bytes.size())
    throw InputError("has a count of " + std::to_string(count) + " triangles, for which it is too short");
}

/// A mesh's place in the scene, and which mesh.
struct Placed {
  aiMatrix4x4 place;
  const aiNode* node;
};

void append(const aiMesh& part, const aiMatrix4x4& place, TriangleMesh* mesh) {
  const int first = static_cast<int>(mesh->vertices.size());
  for (unsigned v = 0; v < part.mNumVertices; ++v) {
    const aiVector3D at = place * part.mVertices[v];
    mesh->vertices.emplace_back(static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(at.z));
    if (!mesh->vertices.back().allFinite()) throw InputError("has a vertex that is not finite (allowed: numbers)");
  }
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const aiFace& face = part.mFaces[f];
    if (face.mNumIndices != 3) continue;
    std::array<int, 3> triangle;
    for (int k = 0; k < 3; ++k) {
      if (face.mIndices[k] >= part.mNumVertices) throw InputError("has a triangle of vertices that are not there");
      triangle[k] = first + static_cast<int>(face.mIndices[k]);
    }
    mesh->triangles.push_back(triangle);
  }
  if (mesh->triangles.size() > MAX_TRIANGLES)
    throw InputError("has too many triangles (allowed: up to " + std::to_string(MAX_TRIANGLES) + ")");
}

TriangleMesh allTrianglesOf(const aiScene& scene) {
  TriangleMesh mesh;
  std::vector<Placed> waiting = {{scene.mRootNode->mTransformation, scene.mRootNode}};
  while (!waiting.empty()) {
    const Placed at = waiting.back();
    waiting.pop_back();
    for (unsigned i = 0; i < at.node->mNumMeshes; ++i) append(*scene.mMeshes[at.node->mMeshes[i]], at.place, &mesh);
    for (unsigned i = 0; i < at.node->mNumChildren; ++i) {
      const aiNode* child = at.node->mChildren[i];
      waiting.push_back({at.place * child->mTransformation, child});
    }
  }
  return mesh;
}

}  // namespace

TriangleMesh parseTriangleMesh(const std::string& bytes, const std::string& format) {
  if (format != ".stl" && format != ".obj" && format != ".dae")
    throw InputError("is of no format that is read (allowed: " + std::string(MESH_FORMATS) + ")");
  if (format == ".dae") checkCollada(bytes);
  if (format == ".stl") checkBinaryStl(bytes);
  const std::string name = "mesh" + format;
  Assimp::Importer importer;
  keepReader(format, &importer);
  importer.SetIOHandler(new OneFile(name, bytes));  // which the importer deletes
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  const aiScene* scene = nullptr;
  std::string complaint;
  try {
    scene = importer.ReadFile(name, aiProcess_Triangulate | aiProcess_SortByPType);
    complaint = importer.GetErrorString();
  } catch (const std::exception& error) {
    complaint = error.what();
  }
  if (!scene || !scene->mRootNode) throw InputError("cannot be read: " + printable(complaint));
  TriangleMesh mesh = allTrianglesOf(*scene);
  if (mesh.triangles.empty()) throw InputError("has no triangles (allowed: surfaces of a solid)");
  return mesh;
}

}  // namespace incision
