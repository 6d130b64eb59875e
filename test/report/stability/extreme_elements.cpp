#include <cmath>

#include "stability.h"
#include "watched.h"

namespace incision::report {
namespace {

TetMesh scaledBlock(const Vec3& scale) {
  TetMesh mesh = block({4, 4, 4}, Vec3::Ones());
  for (Vec3& X : mesh.nodes) X = X.cwiseProduct(scale);
  return mesh;
}

/// A block of which one layer of elements is thin.
TetMesh thinLayer(double thickness) {
  TetMesh mesh = block({4, 4, 4}, Vec3::Ones());
  for (Vec3& X : mesh.nodes)
    if (std::abs(X.x() - 0.5) < 1e-9) X.x() = 0.25 + 0.25 * thickness;
  return mesh;
}

/// Four nodes of a square, two of them raised, between two apexes: the element of the four is a sliver, with good
/// faces.
TetMesh sliver(double height) {
  TetMesh mesh;
  mesh.nodes = {Vec3(-1, 0, height / 2), Vec3(0, -1, -height / 2),
                Vec3(1, 0, height / 2),  Vec3(0, 1, -height / 2),
                Vec3(0, 0, 1),           Vec3(0, 0, -1)};
  mesh.elements = {{0, 1, 2, 4}, {0, 2, 3, 4}, {1, 2, 3, 5}, {0, 1, 3, 5}, {0, 1, 2, 3}};
  for (auto& e : mesh.elements)
    if (sixVolumes(mesh.nodes[e[0]], mesh.nodes[e[1]], mesh.nodes[e[2]], mesh.nodes[e[3]]) < 0) std::swap(e[2], e[3]);
  return mesh;
}

/// What a mesh with bad elements keeps, cut and thrown; `thinness` of its elements from 1e-1 on.
struct Bad {
  std::string name;
  TetMesh (*mesh)(double thinness);
  Vec3 cut_point, cut_normal;
};

TetMesh flat(double s) { return scaledBlock(Vec3(1, 1, s)); }
TetMesh needle(double s) { return scaledBlock(Vec3(s, s, 1)); }

const std::vector<Bad> BAD = {{"flat cells", flat, Vec3(0.41, 0.5, 0), Vec3(1, 0.3, 0)},
                              {"needle cells", needle, Vec3(0, 0, 0.45), Vec3(0, 0, 1)},
                              {"a thin layer", thinLayer, Vec3(0.41, 0.5, 0.5), Vec3(1, 0.3, 0.1)},
                              {"a cut through a thin layer", thinLayer, Vec3(0.25, 0.5, 0.5), Vec3(1, 0.3, 0.1)},
                              {"a sliver, cut", sliver, Vec3(0.1, 0.05, 0), Vec3(1, 0.3, 0.1)}};

/// Thinner elements than this of their length are beyond what is claimed.
constexpr double CLAIMED = 1e-5;

void badElements(Matrix* matrix) {
  nlohmann::json& rows = matrix->data()["thin"] = nlohmann::json::array();
  for (const Bad& bad : BAD) {
    Worst residual, growth, drift;
    for (const Method method : METHODS)
      for (int k = 1; k <= 10; ++k) {
        const double s = std::pow(10, -k);
        Watched body(bad.mesh(s), freeBody(method));
        body.cut(plane(bad.cut_point, bad.cut_normal));
        body.motion.v = randomVectors(body.motion.v.size(), 1, 7);
        body.startWatching();
        body.take(30, 2);
        const Watch& seen = body.seen();
        if (s > 0.99 * CLAIMED) {
          residual.add(seen.residualIfFinite());
          growth.add(seen.kinetic_growth);
          drift.add(seen.drift);
        }
        rows.push_back({{"name", bad.name},
                        {"thinness", s},
                        {"method", nameOf(method)},
                        {"finite", seen.finite},
                        {"drift", seen.drift},
                        {"growth", seen.kinetic_growth},
                        {"iterations", seen.iterations}});
      }
    addResidual(matrix, bad.name + " of 1e-1 to 1e-5: residual", residual.figure());
    addGrowth(matrix, bad.name + ": growth of the kinetic energy", growth.figure());
    addMomentum(matrix, bad.name + ": momentum", drift.figure());
  }
}

/// A free block, cut in two, its copies thrown apart slowly: from soft to where its mass is lost among the digits of
/// its stiffness. The number Δt²E/(ρh²) says how much more the stiffness counts than the mass.
void stiffness(Matrix* matrix) {
  nlohmann::json& rows = matrix->data()["stiff"] = nlohmann::json::array();
  for (const Method method : METHODS) {
    Worst growth, residual, beyond, drift;
    for (int exponent = 0; exponent <= 16; ++exponent) {
      const double number = std::pow(10, exponent), cell = 0.1;
      RigSettings settings = freeBody(method);
      settings.solver.time_step = 1;
      settings.material.young_modulus = number * settings.material.density * cell * cell;
      Watched body(block({6, 4, 4}, cell * Vec3(6, 4, 4)), settings);
      body.cut(plane(Vec3(0.31, 0.2, 0.2), Vec3(1, 0.3, 0.1)));
      throwApart(&body, 1e-3);
      body.take(30, 2);
      const Watch& seen = body.seen();
      const double worst = seen.finite ? seen.kinetic_growth : -1;
      (exponent <= 14 ? growth : beyond).add(worst);
      residual.add(seen.residual_share);
      if (exponent <= 14) drift.add(seen.drift);
      rows.push_back({{"number", number},
                      {"method", nameOf(method)},
                      {"finite", seen.finite},
                      {"drift", seen.drift},
                      {"growth", seen.kinetic_growth},
                      {"iterations", seen.iterations}});
    }
    const std::string with = std::string(", ") + nameOf(method);
    addResidual(matrix, "Δt²E/(ρh²) from 1 to 1e16: residual of the steps taken" + with, residual.figure());
    matrix->add("up to 1e14: growth of the kinetic energy" + with, growth.figure(), GROWTH_BOUND, "no force acts");
    addMomentum(matrix, "up to 1e14: momentum" + with, drift.figure());
    matrix->addLimit("1e15 and 1e16: growth of the kinetic energy" + with, beyond.figure(), GROWTH_BOUND,
                     "the mass is below the rounding of the stiffness");
  }
}

}  // namespace

void extremeElements(Matrix* matrix) {
  matrix->begin("Flat, needle and sliver elements");
  badElements(matrix);
  matrix->begin("Free bodies of any stiffness");
  stiffness(matrix);
}

}  // namespace incision::report
