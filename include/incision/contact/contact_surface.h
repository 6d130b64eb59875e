#pragma once

#include <vector>

#include "incision/base/lists.h"
#include "incision/fem/materials.h"
#include "incision/solver/spring.h"
#include "incision/surface/surface.h"

namespace incision {

/// What of the surface does not change until its topology does.
///
/// A sample is a vertex as seen from triangles that lie nearly flat round it; a vertex on an edge of the surface has
/// one for each side, so that each has a normal. Samples carry the contact's stiffness by the area they stand for.
struct ContactSurface {
  struct Sample {
    int vertex;
    int first, last;  ///< its triangles are around[first] … around[last − 1]
    double area;      ///< a third of theirs at rest [m²]
  };

  /// An edge at which the surface is sharp and convex at rest: one that can meet another edge.
  struct Edge {
    int from, to;                 ///< vertices, from < to
    std::array<int, 2> opposite;  ///< the third corners of its two triangles
    int triangle;                 ///< one of these
  };

  const Surface* surface = nullptr;
  std::vector<Vec3> rest;             ///< of each vertex [m]
  std::vector<Vec3> rest_normal;      ///< of each triangle, unit; zero where it has no area
  std::vector<double> rest_area;      ///< of each triangle [m²]
  std::vector<double> size;           ///< of the elements round each vertex, the mean of their sizes [m]
  std::vector<double> young_modulus;  ///< of the stiffest element round each vertex [Pa]
  std::vector<double> area;           ///< of each vertex: a third of its triangles' at rest [m²]
  std::vector<Sample> samples;        ///< by vertex
  std::vector<int> sample_start;  ///< those of vertex v are samples[sample_start[v]] … samples[sample_start[v + 1] − 1]
  std::vector<int> around;        ///< triangles
  std::vector<Edge> edges;        ///< by their first vertex
  std::vector<int> edge_start;    ///< those of vertex v are edges[edge_start[v]] … edges[edge_start[v + 1] − 1]
  int pieces = 0;                 ///< how many there are of
  std::vector<int> piece;         ///< of each triangle
  std::vector<int> vertex_piece;  ///< of each vertex
  /// Of each vertex, the share of its weights on copies that no other vertex of its piece at its place has: what is
  /// left to open of a slit near its end. 1 where there is no other.
  std::vector<double> unshared;
  Lists<int> cut_triangles;  ///< of each part: those that cuts have made
  double mean_size = 0;      ///< of the vertices [m]
};

/// `surface` must outlive the result; `piece` of each copy.
ContactSurface makeContactSurface(const Surface& surface, const CutMesh& mesh, const Materials& materials,
                                  const std::vector<int>& piece);

/// Whether a triangle has an area at rest. Those that have none close the surface between parts that neither hang
/// together nor are severed; their corners may belong to several parts, to more copies than a spring has room for.
bool hasAreaAtRest(const ContactSurface& surface, int triangle);

/// Adds `sign` times the position of a vertex to what a spring acts on.
void addVertex(const SurfaceVertex& vertex, double sign, Spring* spring);

}  // namespace incision
