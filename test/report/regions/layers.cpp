// Cantilevers of layers, clamped at x = 0 and loaded at their end. With ν = 0 the clamp takes nothing from beam theory.
#include "report/regions/layered_beam.h"
#include "report/regions/solve.h"
#include "report/regions/study.h"

namespace incision::report {
namespace {

using nlohmann::json;

constexpr double SOFT = 1e6, L = 1, H = 0.1;  // [Pa], [m]
// Large enough that rounding of positions does not show; without warping any size is small.
constexpr double DEFLECTION = 0.1 * L;  // [m]

const std::pair<const char*, Method> METHODS[] = {{"direct", Method::DIRECT}, {"iterative", Method::ITERATIVE}};

constexpr int SMALL = 6;  // cells over the height where solvers are compared: an iteration is not given up there

struct Beam {
  const char* name;
  std::vector<bool> stiff;       // of each layer of equal height, from below
  std::vector<int> quick, full;  // cells over the height, so that layers end at faces
};

const Beam BEAMS[] = {{"two layers", {true, false}, {4, 6, 8, 12}, {4, 6, 8, 12, 16, 20}},
                      {"three layers", {false, true, false}, {3, 6, 9, 12}, {6, 9, 12, 18, 24}}};

std::vector<Layer> layersOf(const Beam& beam, double contrast) {
  std::vector<Layer> layers;
  const double height = H / static_cast<double>(beam.stiff.size());
  for (std::size_t k = 0; k < beam.stiff.size(); ++k) {
    const double bottom = static_cast<double>(k) * height;
    layers.push_back({bottom, bottom + height, beam.stiff[k] ? contrast * SOFT : SOFT});
  }
  return layers;
}

/// As wide as a layer is high, of cells that are cubes.
double widthOf(const Beam& beam) { return H / static_cast<double>(beam.stiff.size()); }

TetMesh grid(const Beam& beam, int n) {
  return block({10 * n, n / static_cast<int>(beam.stiff.size()), n}, Vec3(L, widthOf(beam), H));
}

/// Bent so far by theory [m]. Each layer takes its share of the force, as it does along the beam.
RigSettings bent(double deflection, const Beam& beam, double contrast) {
  const std::vector<Layer> layers = layersOf(beam, contrast);
  const LayeredBeam theory(layers, widthOf(beam));
  const double force = deflection / theory.deflection(1, L);
  RigSettings settings = statics(SOFT, 0);
  settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
  for (std::size_t k = 0; k < layers.size(); ++k) {
    const Layer& layer = layers[k];
    RestBox within{Vec3(-1, -1, layer.bottom), Vec3(2, 2, layer.top)}, end = slab(0, L);
    settings.regions.push_back(tissue(within, layer.young_modulus));
    end.min.z() = layer.bottom - 1e-9;
    end.max.z() = layer.top + 1e-9;
    const double traction = force * theory.shares()[k] / (widthOf(beam) * (layer.top - layer.bottom));
    settings.conditions.loads.push_back({end, Vec3(0, 0, traction), 0});
  }
  return settings;
}

/// The end's deflection over that of theory: under a dead load the strain energy is half of the load times its way.
double ratio(const Solution& solution, double deflection, const LayeredBeam& theory) {
  return 2 * solution.energy / (deflection * deflection) * theory.deflection(1, L);
}

json study(const Beam& beam, double contrast, bool quick) {
  const LayeredBeam theory(layersOf(beam, contrast), widthOf(beam));
  const RigSettings settings = bent(DEFLECTION, beam, contrast);
  json points, solvers;
  for (const int n : quick ? beam.quick : beam.full) {
    const TetMesh mesh = grid(beam, n);
    const Solution solution = solve(mesh, settings, quick ? 1 : 3);
    json at = pointOf(mesh, solution);
    at["cells"] = n;
    // Over the height of what is stiff.
    at["stiff_cells"] = contrast == 1 ? n : n / static_cast<int>(beam.stiff.size());
    // The beam is too stiff by this share.
    at["error"] = 1 / ratio(solution, DEFLECTION, theory) - 1;
    points.push_back(at);
  }
  const TetMesh mesh = grid(beam, SMALL);
  for (const auto& [name, method] : METHODS)
    solvers[name] = ratio(solve(mesh, settings, 1, method), DEFLECTION, theory);
  return {{"beam", beam.name},
          {"contrast", contrast},
          {"shear", theory.shear(1, L) / theory.deflection(1, L)},
          {"points", points},
          {"solvers", solvers}};
}

/// Of the beam of two layers under smaller and smaller loads: how far it bends by either solver, over theory.
json studySmallLoads(double contrast, int n) {
  const Beam& beam = BEAMS[0];
  const LayeredBeam theory(layersOf(beam, contrast), widthOf(beam));
  const TetMesh mesh = grid(beam, n);
  json points;
  for (const double deflection : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, DEFLECTION}) {
    json at = {{"deflection", deflection / L}};
    for (const auto& [name, method] : METHODS) {
      const Solution solution = solve(mesh, bent(deflection, beam, contrast), 1, method);
      at[name] = ratio(solution, deflection, theory);
    }
    points.push_back(at);
  }
  return {{"contrast", contrast}, {"cells", n}, {"points", points}};
}

/// The share of shear in the deflection of stiff faces round a soft core.
double shearOfSoftCore(double contrast) {
  const LayeredBeam theory(layersOf({"soft core", {true, false, true}, {}, {}}, contrast), H / 3);
  return theory.shear(1, L) / theory.deflection(1, L);
}

}  // namespace

json studyLayers(bool quick) {
  using Doubles = std::vector<double>;
  json curves, small;
  for (const double contrast : {1.0, 1e4})
    for (const int n : {SMALL, 8}) small.push_back(studySmallLoads(contrast, n));
  for (const Beam& beam : BEAMS)
    for (const double contrast : quick ? Doubles{1, 100, 1e4} : Doubles{1, 10, 100, 1e3, 1e4})
      curves.push_back(study(beam, contrast, quick));
  return {{"curves", curves}, {"small_loads", small}, {"soft_core", {shearOfSoftCore(100), shearOfSoftCore(1e4)}}};
}

}  // namespace incision::report
