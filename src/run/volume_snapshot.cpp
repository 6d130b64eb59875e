#include <numeric>
#include <ostream>

#include "incision/cut/point.h"
#include "incision/run/snapshot.h"
#include "vtk_text.h"

namespace incision {
namespace {

/// The parts as cells: those of whole elements share the copies as their points, the others bring corners of their own.
struct Cells {
  std::vector<Vec3> points, displacements;  // [m]
  std::vector<std::vector<int>> corners;    // points of each cell
  std::vector<std::vector<int>> faces;      // of a polyhedron: how many, then of each how many points and which
};

void addWhole(const Part& part, Cells* cells) {
  cells->corners.emplace_back(part.copies.begin(), part.copies.end());
  cells->faces.emplace_back();
}

void addPolyhedron(const Part& part, const Polytope& polytope, const std::vector<Vec3>& x, const std::vector<Vec3>& u,
                   Cells* cells) {
  const int first = static_cast<int>(cells->points.size());
  for (const Barycentric& corner : polytope.corners) {
    cells->points.push_back(at(part, corner, x));
    cells->displacements.push_back(at(part, corner, u));
  }
  std::vector<int> corners(polytope.corners.size()), faces = {static_cast<int>(polytope.facets.size())};
  std::iota(corners.begin(), corners.end(), first);
  for (const Facet& facet : polytope.facets) {
    faces.push_back(static_cast<int>(facet.corners.size()));
    for (int corner : facet.corners) faces.push_back(first + corner);
  }
  cells->corners.push_back(corners);
  cells->faces.push_back(faces);
}

Cells cellsOf(const DeformableBody& body) {
  const CutMesh& mesh = body.mesh();
  Cells cells;
  cells.points = body.positions();
  for (int c = 0; c < mesh.numCopies(); ++c)
    cells.displacements.push_back(body.positions()[c] - mesh.mesh().nodes[mesh.copyNode(c)]);
  const std::vector<Vec3> u = cells.displacements;
  for (std::size_t p = 0; p < mesh.parts().size(); ++p) {
    const Part& part = mesh.parts()[p];
    if (mesh.isWhole(part.element))
      addWhole(part, &cells);
    else
      addPolyhedron(part, mesh.polytope(static_cast<int>(p)), body.positions(), u, &cells);
  }
  return cells;
}

/// Lists one after the other, and where each ends.
void writeLists(std::ostream& out, const char* name, const char* ends_name,
                const std::vector<std::vector<int>>& lists) {
  writeArray(out, "Int64", name, 1, lists.size(),
             [&](std::size_t i) { writeRow(out, lists[i], static_cast<int>(lists[i].size())); });
  std::size_t end = 0;
  writeArray(out, "Int64", ends_name, 1, lists.size(), [&](std::size_t i) {
    end += lists[i].size();
    if (lists[i].empty())
      out << -1;  // for a cell that needs none
    else
      out << end;
  });
}

}  // namespace

void writeVolumeSnapshot(std::ostream& out, const DeformableBody& body) {
  const Cells cells = cellsOf(body);
  std::vector<int> parts(cells.corners.size());
  std::iota(parts.begin(), parts.end(), 0);
  const auto isWhole = [&](std::size_t i) { return cells.faces[i].empty(); };
  writeGrid(out, cells.points.size(), parts.size(), [&] {
    out << "<Points>\n";
    writeArray(out, "Float64", "Points", 3, cells.points.size(),
               [&](std::size_t i) { writeRow(out, cells.points[i], 3); });
    out << "</Points>\n<PointData>\n";
    writeArray(out, "Float64", "displacement", 3, cells.points.size(),
               [&](std::size_t i) { writeRow(out, cells.displacements[i], 3); });
    out << "</PointData>\n<Cells>\n";
    writeLists(out, "connectivity", "offsets", cells.corners);
    writeArray(out, "UInt8", "types", 1, parts.size(),
               [&](std::size_t i) { out << (isWhole(i) ? VTK_TETRAHEDRON : VTK_POLYHEDRON); });
    writeLists(out, "faces", "faceoffsets", cells.faces);
    out << "</Cells>\n<CellData>\n";
    writePartData(out, body, parts);
    out << "</CellData>\n";
  });
}

}  // namespace incision
