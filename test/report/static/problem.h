#pragma once

#include <functional>
#include <string>
#include <vector>

#include "support/rig.h"

namespace incision::report {

/// How a mesh is made and whether the crack lies on its faces; otherwise the crack goes through elements.
struct Way {
  bool unstructured;  ///< by Gmsh; otherwise a grid
  bool faces;
  bool longer =
      false;  ///< the crack is made longer, by the MISSING_EDGES (mean_edge.h) that a crack inside elements lacks
};

/// One static solve: a body, what holds and loads it, and what is cut before.
struct Case {
  RigSettings settings;
  std::function<Insertion(Rig* rig, double longer)> cut;  ///< with a crack longer by so much [m]; empty: nothing
  /// Σ F² [N²] over the loads' resultants that the energy is scaled to; 0: as it is. Boundary faces that a crack
  /// divides carry no load of one side.
  double load_squares = 0;
};

/// A figure of a problem, from the strain energies [J] of some of its cases.
struct Quantity {
  std::string name;
  double answer;
  std::vector<int> cases;
  std::function<double(const std::vector<double>& energies)> from;
  /// Whether the error is that of its inverse, a stiffness, which linear elements overestimate by C h².
  bool compliance;
  /// How much shorter [m] a crack is that has this value; empty where no crack ends in the body.
  std::function<double(double value)> missing = {};
};

/// A problem with a known answer, for meshes of many sizes.
struct Problem {
  std::string name;
  std::vector<Way> ways;
  std::function<TetMesh(int cells, bool faces)> grid;
  std::string geometry;  ///< the Gmsh script
  RestBox fine;          ///< where the elements are of one size, which the errors are held against
  /// Numbers of cells for a way.
  std::function<std::vector<int>(const Way& way, bool quick)> cells;
  std::vector<Case> cases;
  std::vector<Quantity> quantities;
  int order;  ///< with which power of the elements' edge the error is expected to fall
};

Problem cantilever();
Problem splitCantilever();
Problem doubleCantileverBeam();
Problem edgeCrack();
Problem pennyCrack();

}  // namespace incision::report
