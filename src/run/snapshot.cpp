#include "incision/run/snapshot.h"

#include <ostream>

#include "incision/fem/linear_tet.h"
#include "vtk_text.h"

namespace incision {
namespace {

void writeGeometry(std::ostream& out, const Surface& surface, const std::vector<Vec3>& x) {
  const std::size_t n = surface.triangles.size();
  out << "<Points>\n";
  writeArray(out, "Float64", "Points", 3, x.size(), [&](std::size_t i) { writeRow(out, x[i], 3); });
  out << "</Points>\n<Cells>\n";
  writeArray(out, "Int64", "connectivity", 1, n, [&](std::size_t i) { writeRow(out, surface.triangles[i], 3); });
  writeArray(out, "Int64", "offsets", 1, n, [&](std::size_t i) { out << 3 * (i + 1); });
  writeArray(out, "UInt8", "types", 1, n, [&](std::size_t) { out << VTK_TRIANGLE; });
  out << "</Cells>\n";
}

}  // namespace

void writePositions(std::ostream& out, const DeformableBody& body) {
  for (const Vec3& x : body.nodePositions()) out << x.x() << ' ' << x.y() << ' ' << x.z() << '\n';
}

void writePartData(std::ostream& out, const DeformableBody& body, const std::vector<int>& parts) {
  const std::vector<Mat3> stress = body.partStress();
  int num_pieces = 0;
  const std::vector<int> pieces = body.mesh().copyPieces(&num_pieces);
  const Regions& regions = body.materials().regions();
  const auto partOf = [&](std::size_t i) -> const Part& { return body.mesh().parts()[parts[i]]; };
  const std::size_t n = parts.size();
  writeArray(out, "Float64", "stress", 9, n, [&](std::size_t i) { writeMatrix(out, stress[parts[i]]); });
  writeArray(out, "Float64", "von_mises", 1, n, [&](std::size_t i) { out << vonMises(stress[parts[i]]); });
  writeArray(out, "Int32", "part", 1, n, [&](std::size_t i) { out << parts[i]; });
  writeArray(out, "Int32", "region", 1, n, [&](std::size_t i) { out << regions.of(partOf(i).element); });
  writeArray(out, "Int32", "piece", 1, n, [&](std::size_t i) { out << pieces[partOf(i).copies[0]]; });
}

void writeSnapshot(std::ostream& out, const DeformableBody& body) {
  const Surface& surface = body.surface();
  const std::vector<Vec3> x = surfacePositions(surface, body.positions());
  const std::size_t n = surface.triangles.size();
  writeGrid(out, x.size(), n, [&] {
    writeGeometry(out, surface, x);
    out << "<CellData>\n";
    writePartData(out, body, surface.part);
    writeArray(out, "UInt8", "cut_face", 1, n, [&](std::size_t i) { out << (surface.cut_face[i] ? 1 : 0); });
    out << "</CellData>\n";
  });
}

}  // namespace incision
