#include <algorithm>
#include <cmath>
#include <numeric>

#include "incision/body/deformable_body.h"
#include "stability.h"
#include "support/random.h"
#include "support/tool.h"
#include "watched.h"

namespace incision::report {
namespace {

/// Pieces by joining parts that meet on a face and are not severed, whatever their copies.
int piecesByFaces(const CutMesh& mesh) {
  std::vector<int> link(mesh.parts().size());
  std::iota(link.begin(), link.end(), 0);
  const auto root = [&](int p) {
    while (link[p] != p) p = link[p] = link[link[p]];
    return p;
  };
  int pieces = static_cast<int>(link.size());
  for (int e = 0; e < static_cast<int>(mesh.mesh().elements.size()); ++e)
    for (int face = 0; face < 4; ++face) {
      if (mesh.topology().neighbours[e][face] < e) continue;
      for (const FacePair& pair : mesh.facePairs(e, face)) {
        if (pair.severed_by || root(pair.part) == root(pair.other)) continue;
        link[root(pair.part)] = root(pair.other);
        --pieces;
      }
    }
  return pieces;
}

void addCounts(Matrix* matrix, const std::string& name, const CutMesh& mesh) {
  int pieces = 0;
  mesh.copyPieces(&pieces);
  double volume = 0;
  for (const Part& part : mesh.parts()) volume += part.fraction;
  const double elements = static_cast<double>(mesh.mesh().elements.size());
  matrix->add(name + ": pieces too many or too few", std::abs(pieces - piecesByFaces(mesh)), 0,
              "parts joined through their faces");
  matrix->add(name + ": volume, relative error", std::abs(volume / elements - 1), 1e-12, "parts fill the body");
}

/// A thousand rectangles in a small mesh.
void rectangles(Matrix* matrix) {
  const int count = matrix->quick() ? 300 : 1000;
  const GridSettings box = {{3, 3, 3}, Vec3::Ones(), Vec3::Zero()};
  test::Random random(31);
  Watched body(test::jitteredGrid(box, 0.2, &random), freeBody(Method::DIRECT));
  int refused = 0;
  for (int k = 0; k < count; ++k) try {
      body.cut(random.rectangle(box, 0.1, 0.35));
    } catch (const InputError&) {
      ++refused;
    }
  const std::string name =
      std::to_string(count) + " rectangles, " + std::to_string(body.mesh.parts().size()) + " parts";
  matrix->add(name + ": refused", refused, 0, "far from the limits");
  addCounts(matrix, name, body.mesh);
  Flights flights;
  flights.fly(&body, 5, 5);
  flights.report(matrix, name + ", flight");
}

/// Unbounded planes through a body of six elements until the limit of parts refuses them, and then as many again.
void planesToTheLimit(Matrix* matrix) {
  const int count = matrix->quick() ? 60 : 1000;
  const GridSettings box = {{1, 1, 1}, Vec3::Ones(), Vec3::Zero()};
  test::Random random(33);
  Watched body(gridMesh(box), freeBody(Method::ITERATIVE));
  int refused = 0, changed = 0;
  for (int k = 0; k < count; ++k) {
    const std::size_t parts = body.mesh.parts().size();
    try {
      body.cut(random.plane(box));
    } catch (const InputError&) {
      ++refused;
      changed += body.mesh.parts().size() != parts;
    }
  }
  const std::string name =
      std::to_string(count) + " planes through six elements, " + std::to_string(refused) + " refused";
  matrix->add(name + ": refused ones that changed anything", changed, 0, "a cut is taken whole or not at all");
  addCounts(matrix, name, body.mesh);
  Flights flights;
  flights.fly(&body, 3, 3);
  flights.report(matrix, name + ", flight of " + std::to_string(body.pieces()) + " pieces");
}

/// One element in as many parts as it may have.
void oneElement(Matrix* matrix) {
  TetMesh element;
  element.nodes = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)};
  element.elements = {{0, 1, 2, 3}};
  for (const Method method : METHODS) {
    test::Random random(30);
    Watched body(element, freeBody(method));
    for (bool full = false; !full;) try {
        body.cut(plane(Vec3::Constant(0.25) + random.vector(0.05), random.direction()));
      } catch (const InputError&) {
        full = true;
      }
    const int parts = static_cast<int>(body.mesh.parts().size());
    const std::string name = "one element in " + std::to_string(parts) + " parts";
    if (method == Method::DIRECT) {
      matrix->add(name + ": parts short of a thousand", std::max(0, 1000 - parts), 0, "the limit is 4096");
      matrix->add(name + ": pieces too many or too few", std::abs(body.pieces() - parts), 0, "each part is a piece");
      addCounts(matrix, name, body.mesh);
    }
    Flights flights;
    flights.fly(&body, 10, 5);
    flights.report(matrix, name + ", flight");
  }
}

/// Random strokes of the tool through a body that swings.
void strokes(Matrix* matrix) {
  Scene scene;
  scene.body.grid = GridSettings{{8, 4, 4}, Vec3(1, 0.5, 0.5), Vec3::Zero()};
  scene.body.material = {3e5, 0.4, 1000, 0, 1e-3};
  scene.boundary = {{slab(0, 0), Vec3::Zero()}};
  scene.tools = {bladeTool(Edge{Vec3(0, 0, -0.1), Vec3(0, 0, 0.1)})};
  const int count = matrix->quick() ? 20 : 150;
  for (const Method method : METHODS) {
    scene.solver = {0.01, method, 1e-6, 1};
    DeformableBody body(scene, loadMesh(scene));
    test::Random random(95);
    int failed = 0;
    for (int stroke = 0; stroke < count; ++stroke) {
      Vec3 at = Vec3(0.5, 0.25, 0.2) + random.vector(0.5);
      body.liftTool();
      for (int k = 0; k < 10; ++k) try {
          at += random.vector(0.1);
          body.guideTool({{at, Eigen::Quaterniond(random.rotation())}});
          body.step();
        } catch (const StepFailed&) {
          ++failed;
        }
    }
    const std::string name =
        std::to_string(count) + " random strokes, " + std::to_string(body.counts().parts) + " parts, " + nameOf(method);
    matrix->add(name + ": failed steps", failed, 0, "every step can be taken, and leaves finite values");
    addCounts(matrix, name, body.mesh());
  }
}

/// A cut given in the body at rest, where its first element has carried it.
PlaneCut carried(PlaneCut cut, const Rig& body) {
  const Part& part = body.mesh.parts()[0];
  const auto& x = body.motion.x;
  const auto& c = part.copies;
  const RestElement rest = restElements(body.mesh.mesh())[part.element];
  const Mat3 F = gradient(x[c[0]], x[c[1]], x[c[2]], x[c[3]], rest);
  cut.point = x[c[0]] + F * (cut.point - body.mesh.mesh().nodes[body.mesh.copyNode(c[0])]);
  cut.normal = F * cut.normal;
  cut.tangent = F * cut.tangent;
  return cut;
}

/// A small body, thrown and cut now and then.
void longRun(Matrix* matrix) {
  const int steps = matrix->quick() ? 3000 : 100000;
  const GridSettings box = {{3, 2, 2}, Vec3(0.6, 0.4, 0.4), Vec3::Zero()};
  for (const bool held : {false, true}) {
    RigSettings settings = freeBody(Method::DIRECT);
    if (held) {
      settings.conditions.gravity = Vec3(0, 0, -9.81);
      settings.conditions.clamps = {{slab(0, 0), Vec3::Zero()}};
    }
    Watched body(gridMesh(box), settings);
    test::Random random(96);
    if (held)
      body.startWatching();
    else
      throwApart(&body);
    int k = 0;
    body.take(steps, steps / 100, [&] {
      if (++k % (steps / 10) == steps / 20) body.cut(carried(random.rectangle(box, 0.2, 0.6), body));
    });
    const std::string name = std::to_string(steps) + " steps with " + std::to_string(body.mesh.numCracks()) +
                             " cuts, " + (held ? "held" : "free");
    addResidual(matrix, name + ": residual", body.seen().residualIfFinite());
    addGrowth(matrix, name + ": energy growth", body.seen().growth);
    if (!held) addMomentum(matrix, name + ": momentum", body.seen().drift);
  }
}

}  // namespace

void manyCuts(Matrix* matrix) {
  matrix->begin("A thousand cuts, a thousand parts");
  rectangles(matrix);
  planesToTheLimit(matrix);
  oneElement(matrix);
  matrix->begin("Strokes and long runs");
  strokes(matrix);
  longRun(matrix);
}

}  // namespace incision::report
