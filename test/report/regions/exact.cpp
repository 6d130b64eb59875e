// Bodies whose displacement is linear in each part, and so in each element: a rod of two parts in series, and a body
// across whose interface stretches and shears jump, held on its surface.
#include <cmath>
#include <random>

#include "report/regions/solve.h"
#include "report/regions/study.h"

namespace incision::report {
namespace {

using nlohmann::json;

// As static/bar.geo has it.
constexpr double L = 1, H = 0.2, INTERFACE = 0.4 * L, SOFT = 1e6;
constexpr int LENGTHWISE = 25;  // cells

/// A grid or Gmsh's mesh with faces at the interface.
TetMesh bar(bool unstructured) {
  if (unstructured) return gmshMesh("static/bar.geo", LENGTHWISE / 5);
  TetMesh mesh = block({LENGTHWISE, LENGTHWISE / 5, LENGTHWISE / 5}, Vec3(L, H, H));
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-0.2 * L / LENGTHWISE, 0.2 * L / LENGTHWISE);
  const RestBox box = boundsOf(mesh);
  for (Vec3& X : mesh.nodes) {
    if (isOnSurface(box, X)) continue;
    if (std::abs(X.x() - INTERFACE) > 1e-9) X.x() += uniform(generator);
    X.y() += uniform(generator);
    X.z() += uniform(generator);
  }
  return mesh;
}

/// Largest |u − exact| over the largest |exact|, by the method.
json errors(const TetMesh& mesh, const RigSettings& settings, const std::function<Vec3(const Vec3&)>& exact) {
  json found;
  for (const auto& [name, method] : {std::pair("direct", Method::DIRECT), std::pair("iterative", Method::ITERATIVE)}) {
    const Solution solution = solve(mesh, settings, 1, method);
    const std::vector<Vec3>& u = solution.u;
    double error = 0, size = 0;
    for (std::size_t n = 0; n < u.size(); ++n) {
      error = std::max(error, (u[n] - exact(mesh.nodes[n])).norm());
      size = std::max(size, exact(mesh.nodes[n]).norm());
    }
    found[name] = error / size;
    found["gave_up"] = solution.gave_up;
  }
  return found;
}

RigSettings ofTwo(double contrast, double poisson_ratio) {
  RigSettings settings = statics(SOFT, poisson_ratio);
  settings.regions = {tissue(RestBox{Vec3(INTERFACE, -1, -1), Vec3(2, 1, 1)}, contrast * SOFT)};
  return settings;
}

/// δ = F Σ L_k / E_k A, and in between as much as lies before.
json series(const TetMesh& mesh, double contrast) {
  // Large enough that rounding of positions does not show; without warping any size is small.
  const double traction = 0.1 * SOFT * std::min(1.0, contrast);
  RigSettings settings = ofTwo(contrast, 0);
  settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
  settings.conditions.loads = {{slab(0, L), Vec3(traction, 0, 0), 0}};
  return errors(mesh, settings, [=](const Vec3& X) {
    const double soft = std::min(X.x(), INTERFACE), stiff = X.x() - soft;
    return Vec3(traction / SOFT * (soft + stiff / contrast), 0, 0);
  });
}

/// Stretches along the interface are alike on its two sides; those across it, and shears, are such that the traction
/// is.
json patch(const TetMesh& mesh, double contrast) {
  constexpr double NU = 0.3, ALONG_Y = 2e-4, ALONG_Z = -1e-4, TURN = 3e-4;
  const Vec3 soft(1e-3, 5e-4, -7e-4);  // ε_xx, γ_xy, γ_xz
  // (1 − ν) ε_xx + ν (ε_yy + ε_zz) jumps by the contrast.
  const double along = NU / (1 - NU) * (ALONG_Y + ALONG_Z);
  const Vec3 stiff((soft.x() + along) / contrast - along, soft.y() / contrast, soft.z() / contrast);
  const auto field = [=](const Vec3& X) {
    const double before = std::min(X.x(), INTERFACE), beyond = X.x() - before;
    const Vec3 along_interface(0, ALONG_Y * X.y() + TURN * X.z(), ALONG_Z * X.z() - TURN * X.y());
    return Vec3(before * soft + beyond * stiff + along_interface);
  };
  RigSettings settings = ofTwo(contrast, NU);
  const RestBox box = boundsOf(mesh);
  settings.conditions.clamps = holdEach(
      mesh, [&](const Vec3& X) { return isOnSurface(box, X); }, field);
  return errors(mesh, settings, field);
}

}  // namespace

json studyExact(bool quick) {
  using Doubles = std::vector<double>;
  json bodies;
  for (const bool unstructured : {false, true}) {
    const TetMesh mesh = bar(unstructured);
    for (const double contrast : quick ? Doubles{1e-4, 1, 1e4} : Doubles{1e-4, 1e-2, 1, 100, 1e4}) {
      bodies.push_back({{"problem", "rod"}, {"unstructured", unstructured}, {"contrast", contrast}});
      bodies.back().update(series(mesh, contrast));
      bodies.push_back({{"problem", "patch"}, {"unstructured", unstructured}, {"contrast", contrast}});
      bodies.back().update(patch(mesh, contrast));
    }
  }
  return {{"cells", LENGTHWISE}, {"bodies", bodies}};
}

}  // namespace incision::report
