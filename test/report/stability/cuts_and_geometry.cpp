#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry.h"
#include "stability.h"
#include "support/random.h"
#include "watched.h"

namespace incision::report {
namespace {

/// A zone's tip that meets the rest of it in less than 1e-12 of a face comes off: connections of that size count as
/// nothing. Pieces of less than this share of an element are such tips.
constexpr double TIP = 1e-15;

/// Largest difference from 1 of the shares of an element's parts.
double volumeError(const CutMesh& mesh) {
  std::vector<double> filled(mesh.mesh().elements.size(), 0);
  for (const Part& part : mesh.parts()) filled[part.element] += part.fraction;
  double worst = 0;
  for (double sum : filled) worst = std::max(worst, std::abs(sum - 1));
  return worst;
}

/// Pieces that are more than the tip of a zone.
int wholePieces(const Rig& body) {
  std::vector<double> share(body.pieces(), 0);
  for (const Part& part : body.mesh.parts()) share[body.step.pieceOf()[part.copies[0]]] += part.fraction;
  return static_cast<int>(std::count_if(share.begin(), share.end(), [](double s) { return s > TIP; }));
}

/// Snapping moves a crack that passes closer than this by a node.
bool passesByANode(const PlaneCut& plane, const CutMesh& mesh) {
  for (int n = 0; n < static_cast<int>(mesh.mesh().nodes.size()); ++n)
    if (std::abs(plane.normal.dot(mesh.mesh().nodes[n] - plane.point)) < 2 * SNAP * mesh.shortestEdge(n)) return true;
  return false;
}

/// Random planes part a box into zones, whatever the mesh.
void randomPlanes(Matrix* matrix) {
  const GridSettings box = {{3, 3, 2}, Vec3(1, 0.9, 0.7), Vec3(-0.2, 0.1, 0)};
  test::Random random(91);
  Worst volume;
  Flights flights;
  int most = 0;
  for (const int count : {5, 10, 20, 40}) {
    int wrong = 0;
    const int runs = matrix->quick() ? 2 : 10;
    for (int run = 0; run < runs; ++run) {
      const Method method = METHODS[run % 2];
      Watched body(test::jitteredGrid(box, 0.2, &random), freeBody(method));
      std::vector<PlaneCut> planes;
      while (static_cast<int>(planes.size()) < count) {
        const PlaneCut plane = random.plane(box);
        if (passesByANode(plane, body.mesh)) continue;
        planes.push_back(plane);
        body.cut(plane);
      }
      wrong += std::abs(wholePieces(body) - zonesOfPlanes(box, planes));
      most = std::max(most, body.pieces());
      volume.add(volumeError(body.mesh));
      flights.fly(&body, 5, 5);
    }
    const std::string name =
        std::to_string(count) + " planes, " + std::to_string(runs) + " times: pieces too many or too few";
    const std::string reason = "zones counted from the planes alone";
    if (count < 40)
      matrix->add(name, wrong, 0, reason);
    else
      matrix->addLimit(name, wrong, 0, reason);
  }
  matrix->add("volume of an element's parts, error", volume.figure(), 1e-12, "they fill the element");
  const std::string flight = "flight of up to " + std::to_string(most) + " pieces";
  flights.report(matrix, flight);
}

/// Through nodes, along edges and along faces, in all the ways that small whole numbers give.
void wholeNumbers(Matrix* matrix) {
  const GridSettings box = {{4, 4, 4}, Vec3::Constant(4), Vec3::Zero()};
  const int runs = matrix->quick() ? 10 : 60;
  test::Random random(24);
  const auto whole = [&](int low, int count) { return static_cast<double>(low + random.index(count)); };
  int wrong = 0;
  Flights flights;
  for (int run = 0; run < runs; ++run) {
    const Method method = METHODS[run % 2];
    Watched body(gridMesh(box), freeBody(method));
    std::vector<PlaneCut> planes;
    while (planes.size() < 6) {
      const Vec3 point(whole(0, 5), whole(0, 5), whole(0, 5)), normal(whole(-1, 3), whole(-1, 3), whole(-1, 3));
      if (normal.isZero()) continue;
      planes.push_back(plane(point, normal));
      body.cut(planes.back());
    }
    wrong += std::abs(body.pieces() - zonesBySampling(box, planes, matrix->quick() ? 20000 : 100000));
    flights.fly(&body, 10, 10);
  }
  matrix->add("6 planes through nodes, edges and faces, " + std::to_string(runs) + " times: pieces too many or too few",
              wrong, 0, "zones told apart by random points");
  flights.report(matrix, "flight of these");
}

/// Four parallel planes a hair apart. Beyond SNAP of an edge they are four, within they are one.
void hairApart(Matrix* matrix) {
  int wrong = 0;
  Flights flights;
  nlohmann::json& found = matrix->data()["hair"] = nlohmann::json::array();
  for (const Method method : METHODS)
    for (double gap = 1e-1; gap > 1e-15; gap /= 10) {
      test::Random random(32);
      Watched body(test::jitteredGrid({{3, 3, 3}, Vec3::Ones(), Vec3::Zero()}, 0.2, &random), freeBody(method));
      const Vec3 normal = random.direction(), point = Vec3::Constant(0.5) + random.vector(0.05);
      for (int k = 0; k < 4; ++k) body.cut(plane(point + k * gap * normal, normal));
      // Edges are 0.2 to 0.8 m long.
      const int least = gap > SNAP * 0.8 ? 5 : 2, most = 3 * gap < SNAP * 0.2 ? 2 : 5;
      wrong += body.pieces() < least || body.pieces() > most;
      found.push_back({{"gap", gap}, {"pieces", body.pieces()}, {"method", nameOf(method)}});
      flights.fly(&body, 20, 1);
    }
  matrix->add("four planes 1e-1 to 1e-15 m apart: gaps with a wrong count of pieces", wrong, 0,
              "5 beyond 1e-4 of an edge, 2 well within");
  flights.report(matrix, "flight of these");
}

/// Two planes that cross in the body at a small angle. Where they are nearer than SNAP of an edge they are one, and
/// what lies between them stays with one side.
void smallAngles(Matrix* matrix) {
  const GridSettings box = {{4, 4, 4}, Vec3::Ones(), Vec3::Zero()};
  const int runs = matrix->quick() ? 10 : 100;
  nlohmann::json& found = matrix->data()["angles"] = nlohmann::json::array();
  int wrong = 0, wrong_below = 0, not_severed = 0;
  for (const double angle : {1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 1e-6, 1e-8, 1e-10}) {
    test::Random random(7);
    int fours = 0;
    for (int run = 0; run < runs; ++run) {
      Rig body(test::jitteredGrid(box, 0.2, &random), freeBody(Method::DIRECT));
      const Vec3 normal = random.direction(), axis = normal.cross(random.direction()).normalized();
      const Vec3 point = Vec3::Constant(0.5) + random.vector(0.1);
      body.cut(plane(point, normal));
      body.cut(plane(point, Eigen::AngleAxisd(angle, axis) * normal));
      fours += body.pieces() == 4;
      not_severed += body.pieces() < 2;
    }
    if (angle >= 3e-3) wrong += runs - fours;
    if (angle < 3e-3 && angle > 1e-4) wrong_below += runs - fours;
    found.push_back({{"angle", angle}, {"share", fours / static_cast<double>(runs)}});
  }
  matrix->add("two planes that cross at 3e-3 rad or more: not four pieces", wrong, 0,
              "wedges thinner than 1e-4 of an edge only next to the line");
  matrix->add("at any angle down to 1e-10 rad: less than two pieces", not_severed, 0, "the first cut stays");
  matrix->addLimit("at 1e-3 and 3e-4 rad: not four pieces", wrong_below, 0, "four zones");
}

void theSameAgain(Matrix* matrix) {
  Rig body(block({3, 3, 3}, Vec3::Ones()), freeBody(Method::DIRECT));
  const Vec3 point(0.41, 0.52, 0.47), normal(1, 0.3, 0.2);
  body.cut(plane(point, normal));
  int changed = 0;
  for (int k = 0; k < 100; ++k) changed += body.cut(plane(point, k % 2 ? normal : Vec3(-3 * normal))).changed();
  matrix->add("the same cut a hundred times more: those that changed anything", changed, 0, "nothing is left to cut");
}

}  // namespace

void cutsAndGeometry(Matrix* matrix) {
  matrix->begin("Random planes against geometry");
  randomPlanes(matrix);
  matrix->begin("Planes through nodes, edges and faces");
  wholeNumbers(matrix);
  matrix->begin("Cuts a hair apart, and again");
  hairApart(matrix);
  smallAngles(matrix);
  theSameAgain(matrix);
}

}  // namespace incision::report
