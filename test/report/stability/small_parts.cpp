#include <algorithm>
#include <cmath>

#include "stability.h"
#include "watched.h"

namespace incision::report {
namespace {

constexpr double CELL = 0.1, G = 9.81;

double smallestShare(const CutMesh& mesh) {
  double smallest = 1;
  for (const Part& part : mesh.parts()) smallest = std::min(smallest, part.fraction);
  return smallest;
}

/// A corner of a block, cut off with such a share of its elements.
void alone(Matrix* matrix) {
  Worst share_error;
  Flights flights;
  Worst direct_fall, iterative_fall;
  for (const Method method : METHODS)
    for (int k = 1; k <= 12; k += matrix->quick() && k > 1 ? 5 : 1) {
      const double share = std::pow(10, -k);
      const PlaneCut corner = plane(CELL * std::cbrt(6 * share) / 3 * Vec3::Ones(), Vec3::Ones());
      Watched thrown(block({5, 4, 4}, CELL * Vec3(5, 4, 4)), freeBody(method));
      thrown.cut(corner);
      share_error.add(std::abs(smallestShare(thrown.mesh) / share - 1));
      flights.fly(&thrown, 50, 2);

      RigSettings settings = freeBody(method);
      settings.conditions.gravity = Vec3(1, -2, -9);
      Watched falling(block({5, 4, 4}, CELL * Vec3(5, 4, 4)), settings);
      falling.cut(corner);
      falling.take(50, 0);
      double error = 0;
      for (const Vec3& v : falling.motion.v)
        error = std::max(error, (v / falling.time - settings.conditions.gravity).norm());
      (method == Method::DIRECT ? direct_fall : iterative_fall).add(error / settings.conditions.gravity.norm());
    }
  matrix->add("share of the element, relative error", share_error.figure(), 1e-3,
              "from the plane; rounding of 1e-16 in 1e-12");
  flights.report(matrix, "alone, thrown");
  matrix->add("alone, falling, direct: error of every velocity", direct_fall.figure(), 1e-11,
              "v = g n Δt exactly; rounding of the forces");
  matrix->add("alone, falling, iterative: error of every velocity", iterative_fall.figure(), 1e-4,
              "a hundred times the tolerance");
}

/// How far the lightest piece's centre of mass has sunk, less ρ g L²/(3E), relative to that.
double errorOfSinking(const Watched& body, double length) {
  std::vector<double> mass(body.pieces(), 0), sunk(body.pieces(), 0);
  const std::vector<Vec3> u = body.displacements();
  for (std::size_t c = 0; c < u.size(); ++c) {
    const double m = body.step.assembly().masses()[c];
    mass[body.step.pieceOf()[c]] += m;
    sunk[body.step.pieceOf()[c]] -= m * u[c].z();
  }
  const std::size_t needle = std::min_element(mass.begin(), mass.end()) - mass.begin();
  const Material& material = body.settings().material;
  const double exact = material.density * G * length * length / (3 * material.young_modulus);
  return std::abs(sunk[needle] / mass[needle] / exact - 1);
}

/// The same corners with consistent mass, which knows how small they are: they spin as fast as their size lets them.
void aloneWithConsistentMass(Matrix* matrix) {
  for (const Method method : METHODS) {
    Worst drift, kinetic;
    for (int k = 1; k <= 12; ++k) {
      RigSettings settings = freeBody(method);
      settings.mass = Mass::CONSISTENT;
      Watched body(block({5, 4, 4}, CELL * Vec3(5, 4, 4)), settings);
      body.cut(plane(CELL * std::cbrt(6 * std::pow(10, -k)) / 3 * Vec3::Ones(), Vec3::Ones()));
      throwApart(&body);
      body.take(20, 0);
      drift.add(body.seen().finite ? body.seen().drift : -1);
      kinetic.add(body.seen().kinetic_growth);
    }
    const std::string with = std::string("alone, consistent mass, ") + nameOf(method);
    addMomentum(matrix, with + ": momentum", drift.figure());
    matrix->add(with + ": growth of the kinetic energy", kinetic.figure(), GROWTH_BOUND, "no force acts");
  }
}

/// Needles that hang from the top: along the edge of a block, and through its elements without a node inside.
void chains(Matrix* matrix) {
  Worst residual, growth, sinking;
  for (const Method method : METHODS)
    for (const bool inside : {false, true})
      for (const double width : {1e-1, 1e-2, 1e-3, 1.1e-4}) {
        RigSettings settings = freeBody(method);
        settings.material = {1e6, 0, 1000, 20, 0};
        settings.conditions.gravity = Vec3(0, 0, -G);
        settings.conditions.clamps = {{slab(2, 0.8), Vec3::Zero()}};
        Watched body(block({2, 2, 8}, CELL * Vec3(2, 2, 8)), settings);
        const double from = inside ? 0.3 * CELL : 0;
        for (int axis : {0, 1})
          for (const double at : {from, from + width * CELL}) body.cut(plane(at * Vec3::Ones(), Vec3::Unit(axis)));
        body.startWatching();
        body.take(300, 10);
        residual.add(body.seen().residualIfFinite());
        growth.add(body.seen().growth);
        sinking.add(errorOfSinking(body, 0.8));
      }
  matrix->add("in chains, hanging needles 1e-1 to 1.1e-4 of a cell thick: error of sinking", sinking.figure(), 0.01,
              "ρgL²/3E; eight linear elements: 1/(4·8²)");
  addResidual(matrix, "in chains: residual", residual.figure());
  addGrowth(matrix, "in chains: energy growth", growth.figure());
}

/// Half a block hangs on the other half by a bridge of small parts alone.
void bridges(Matrix* matrix) {
  Worst residual, growth;
  int wrong = 0;
  for (const Method method : METHODS)
    for (const double width : {1e-1, 1e-2, 1e-3, 1.1e-4}) {
      RigSettings settings = freeBody(method);
      settings.material.young_modulus = 1e6;
      settings.conditions.gravity = Vec3(0, 0, -G);
      settings.conditions.clamps = {{slab(2, 0.8), Vec3::Zero()}};
      settings.solver.time_step = 1e-3;
      Watched body(block({3, 3, 8}, CELL * Vec3(3, 3, 8)), settings);
      body.cut(rectangle(Vec3(width * CELL, 0.15, 0.4), Vec3::UnitX(), Vec3::UnitZ(), 4 * CELL, 0));
      body.cut(rectangle(Vec3(width * CELL + 0.2, 0.15, 0.43), Vec3(0, 0.01, 1), Vec3::UnitX(), 0.4, 0));
      wrong += body.pieces() != 1;
      body.startWatching();
      body.take(200, 10);
      residual.add(body.seen().residualIfFinite());
      growth.add(body.seen().growth);
    }
  matrix->add("bridges: bodies that fell apart", wrong, 0, "the bridge is not cut");
  addResidual(matrix, "bridges: residual", residual.figure());
  addGrowth(matrix, "bridges: energy growth", growth.figure());
}

}  // namespace

void smallParts(Matrix* matrix) {
  matrix->begin("Parts of 1e-1 to 1e-12 of an element");
  alone(matrix);
  aloneWithConsistentMass(matrix);
  chains(matrix);
  bridges(matrix);
}

}  // namespace incision::report
