#include "incision/run/snapshot.h"

#include <cmath>
#include <ostream>

namespace incision {

namespace {

constexpr int VTK_TRIANGLE = 5;

// √(3/2 s : s) of the deviator s.
double vonMises(const Mat3& stress) {
  const Mat3 s = stress - stress.trace() / 3 * Mat3::Identity();
  return std::sqrt(1.5 * s.squaredNorm());
}

// One VTK array; `write(i)` puts the i-th entry, its components parted by spaces.
template <class Write>
void writeArray(std::ostream& out, const char* type, const char* name, int components, std::size_t count,
                const Write& write) {
  out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" format=\"ascii\"";
  if (components > 1) out << " NumberOfComponents=\"" << components << '"';
  out << ">\n";
  for (std::size_t i = 0; i < count; ++i) {
    write(i);
    out << '\n';
  }
  out << "</DataArray>\n";
}

void writeGeometry(std::ostream& out, const Surface& surface, const std::vector<Vec3>& x) {
  const auto row = [&](const auto& v) { out << v[0] << ' ' << v[1] << ' ' << v[2]; };
  const std::size_t n = surface.triangles.size();
  out << "<Points>\n";
  writeArray(out, "Float64", "Points", 3, x.size(), [&](std::size_t i) { row(x[i]); });
  out << "</Points>\n<Cells>\n";
  writeArray(out, "Int64", "connectivity", 1, n, [&](std::size_t i) { row(surface.triangles[i]); });
  writeArray(out, "Int64", "offsets", 1, n, [&](std::size_t i) { out << 3 * (i + 1); });
  writeArray(out, "UInt8", "types", 1, n, [&](std::size_t) { out << VTK_TRIANGLE; });
  out << "</Cells>\n";
}

void writeCellData(std::ostream& out, const DeformableBody& body) {
  const Surface& surface = body.surface();
  const std::vector<Mat3> stress = body.partStress();
  int num_pieces = 0;
  const std::vector<int> pieces = body.mesh().copyPieces(&num_pieces);
  const std::vector<Part>& parts = body.mesh().parts();
  const std::size_t n = surface.triangles.size();
  const auto part = [&](std::size_t i) { return static_cast<std::size_t>(surface.part[i]); };
  out << "<CellData>\n";
  writeArray(out, "Float64", "stress", 9, n, [&](std::size_t i) {
    const Mat3& s = stress[part(i)];
    for (int row = 0; row < 3; ++row) out << s(row, 0) << ' ' << s(row, 1) << ' ' << s(row, 2) << ' ';
  });
  writeArray(out, "Float64", "von_mises", 1, n, [&](std::size_t i) { out << vonMises(stress[part(i)]); });
  writeArray(out, "Int32", "part", 1, n, [&](std::size_t i) { out << surface.part[i]; });
  writeArray(out, "UInt8", "cut_face", 1, n, [&](std::size_t i) { out << (surface.cut_face[i] ? 1 : 0); });
  writeArray(out, "Int32", "piece", 1, n,
             [&](std::size_t i) { out << pieces[static_cast<std::size_t>(parts[part(i)].copies[0])]; });
  out << "</CellData>\n";
}

}  // namespace

void writePositions(std::ostream& out, const DeformableBody& body) {
  for (const Vec3& x : body.nodePositions()) out << x.x() << ' ' << x.y() << ' ' << x.z() << '\n';
}

void writeSnapshot(std::ostream& out, const DeformableBody& body) {
  const Surface& surface = body.surface();
  const std::vector<Vec3> x = surfacePositions(surface, body.positions());
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      << "<UnstructuredGrid>\n<Piece NumberOfPoints=\"" << x.size() << "\" NumberOfCells=\"" << surface.triangles.size()
      << "\">\n";
  writeGeometry(out, surface, x);
  writeCellData(out, body);
  out << "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

}  // namespace incision
