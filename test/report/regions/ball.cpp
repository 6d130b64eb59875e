// A ball of radius a in a matrix that is stretched by FAR in all directions, far away: of one Poisson's ratio,
//   u = e X in the ball, u = (FAR + (e − FAR) a³/r³) X outside,  e = FAR (3 K + 4 μ) / (3 K_i + 4 μ),
// K_i being the ball's bulk modulus, K and μ the matrix's. The body is a cube whose surface goes as it does there, so
// that the answer is exact in spite of its size.
#include <cmath>

#include "report/field_distance.h"
#include "report/regions/solve.h"
#include "report/regions/study.h"

namespace incision::report {
namespace {

using nlohmann::json;

constexpr double RADIUS = 0.5, FAR = 1e-3;
constexpr Material MATRIX = {1e6, 0.3, 1e-12, 0, 0};
const RestBox CUBE = {-Vec3::Ones(), Vec3::Ones()};

/// e, for a ball that is so many times as stiff.
double inside(double contrast) {
  const double K = MATRIX.lambda() + 2 * MATRIX.mu() / 3, mu = MATRIX.mu();
  return FAR * (3 * K + 4 * mu) / (3 * contrast * K + 4 * mu);
}

Vec3 exactField(double contrast, const Vec3& X) {
  const double beyond = X.norm() > RADIUS ? std::pow(RADIUS / X.norm(), 3) : 1;
  return (FAR + (inside(contrast) - FAR) * beyond) * X;
}

/// A grid whose elements are the ball's where their centroids are: its surface is a staircase.
TetMesh staircase(int cells) {
  TetMesh mesh = block({cells, cells, cells}, Vec3::Constant(2), -Vec3::Ones());
  PhysicalGroup ball;
  ball.name = "ball";
  for (std::size_t e = 0; e < mesh.elements.size(); ++e) {
    Vec3 centroid = Vec3::Zero();
    for (int n : mesh.elements[e]) centroid += mesh.nodes[n] / 4;
    if (centroid.norm() < RADIUS) ball.elements.push_back(static_cast<int>(e));
  }
  mesh.groups = {ball};
  return mesh;
}

RigSettings stretched(const TetMesh& mesh, double contrast) {
  RigSettings settings = statics(MATRIX.young_modulus, MATRIX.poisson_ratio);
  Place place;
  place.group = "ball";
  settings.regions = {tissue(place, contrast * MATRIX.young_modulus)};
  settings.conditions.clamps = holdEach(
      mesh, [](const Vec3& X) { return isOnSurface(CUBE, X); }, [=](const Vec3& X) { return exactField(contrast, X); });
  return settings;
}

/// A third of the mean of div u over the ball's elements, and their volume.
std::pair<double, double> meanStrain(const TetMesh& mesh, const std::vector<Vec3>& u) {
  Place place;
  place.group = "ball";
  double sum = 0, volume = 0;
  for (int e : elementsAt(place, mesh)) {
    const auto& nodes = mesh.elements[e];
    Mat3 edges, stretches;
    for (int i = 0; i < 3; ++i) {
      edges.col(i) = mesh.nodes[nodes[i + 1]] - mesh.nodes[nodes[0]];
      stretches.col(i) = u[nodes[i + 1]] - u[nodes[0]];
    }
    sum += elementVolume(mesh, e) * (stretches * edges.inverse()).trace() / 3;
    volume += elementVolume(mesh, e);
  }
  return {sum / volume, volume};
}

json point(const TetMesh& mesh, int cells, double contrast, int repeats) {
  constexpr double PI = 3.14159265358979323846, BALL = 4 * PI / 3 * RADIUS * RADIUS * RADIUS;
  const Solution solution = solve(mesh, stretched(mesh, contrast), repeats);
  const auto [strain, volume] = meanStrain(mesh, solution.u);
  json result = pointOf(mesh, solution);
  result["cells"] = cells;
  result["error"] = strain / inside(contrast) - 1;
  result["displacement"] = distanceFrom([=](const Vec3& X) { return exactField(contrast, X); }, mesh, solution.u);
  result["volume"] = volume / BALL - 1;
  return result;
}

/// The mean strain by either solver, each over the exact one.
json bothSolvers(const TetMesh& mesh, double contrast) {
  json found = {{"contrast", contrast}};
  for (const auto& [name, method] : {std::pair("direct", Method::DIRECT), std::pair("iterative", Method::ITERATIVE)}) {
    const Solution solution = solve(mesh, stretched(mesh, contrast), 1, method);
    found[name] = meanStrain(mesh, solution.u).first / inside(contrast);
    found[std::string(name) + "_ms"] = solution.ms;
  }
  return found;
}

}  // namespace

json studyBall(bool quick) {
  using Doubles = std::vector<double>;
  const Doubles contrasts = quick ? Doubles{1e-4, 1e-2, 1, 100, 1e4} : Doubles{1e-4, 1e-2, 0.1, 1, 10, 100, 1e4};
  const std::vector<int> sizes = quick ? std::vector<int>{8, 12, 16, 24} : std::vector<int>{8, 12, 16, 24, 32};
  json curves, solvers;
  for (const bool conforming : {false, true}) {
    std::vector<TetMesh> meshes;
    for (const int cells : sizes) meshes.push_back(conforming ? gmshMesh("regions/ball.geo", cells) : staircase(cells));
    for (const double contrast : contrasts) {
      json points;
      for (std::size_t k = 0; k < sizes.size(); ++k)
        points.push_back(point(meshes[k], sizes[k], contrast, quick ? 1 : 3));
      curves.push_back({{"conforming", conforming}, {"contrast", contrast}, {"points", points}});
      if (conforming) solvers.push_back(bothSolvers(meshes[1], contrast));
    }
  }
  return {{"radius", RADIUS}, {"curves", curves}, {"solvers", solvers}};
}

}  // namespace incision::report
