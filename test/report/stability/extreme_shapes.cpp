#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "stability.h"
#include "support/random.h"
#include "watched.h"

namespace incision::report {
namespace {

const Vec3 SIZE(0.6, 0.2, 0.2);

/// The slowest vibration along the free bar, of ω = π √(E/ρ)/L, is critically damped: β = 2/ω.
constexpr double OMEGA = M_PI * 10 / 0.6;
const Material DAMPED = {1e5, 0.3, 1000, 0, 2 / OMEGA};

/// Recovered: strains of some 0.3 % of those at the start are left.
constexpr double RECOVERED = 1e-5;

/// A critically damped vibration is down to that after 8.3/ω.
constexpr double TIME_TO_RECOVER = 10 * 8.3 / OMEGA;
const char* const RECOVERY_REASON =
    "to 1e-5 of the elastic energy, nothing inside out; ten times the critically damped";

class Bar : public Watched {
 public:
  Bar(Method method, const std::vector<Clamp>& clamps) : Watched(block({8, 3, 3}, SIZE), settingsOf(method, clamps)) {
    cut(rectangle(Vec3(0.31, 0.1, 0.2), Vec3(1, 0.1, 0.2), Vec3::UnitZ(), 0.2, 0));
  }

  /// Least det F of the parts.
  double leastVolume() const {
    const std::vector<RestElement> rest = restElements(mesh.mesh());
    double least = 1;
    for (const Part& part : mesh.parts()) {
      const auto& c = part.copies;
      const Mat3 F = gradient(motion.x[c[0]], motion.x[c[1]], motion.x[c[2]], motion.x[c[3]], rest[part.element]);
      least = std::min(least, F.determinant());
    }
    return least;
  }

  /// Simulated time [s] until it has recovered from an elastic energy; −1 when that takes three times the bound.
  double timeToRecover(double from) {
    const double start = time;
    while (time < start + 3 * TIME_TO_RECOVER && seen().finite) {
      take(1, leastVolume() > 0.1 ? 5 : 0);  // the rotation of flat parts is anyone's choice, so no reference there
      if (elasticEnergy() < RECOVERED * from && leastVolume() > 0.5) return time - start;
    }
    return -1;
  }

 private:
  static RigSettings settingsOf(Method method, const std::vector<Clamp>& clamps) {
    RigSettings settings = freeBody(method);
    settings.material = DAMPED;
    settings.solver.time_step = 0.005;
    settings.conditions.clamps = clamps;
    return settings;
  }
};

/// Where the right end of the bar stands at a share of its way.
using Way = std::function<Vec3(const Vec3& X, double share)>;

Vec3 stretched(const Vec3& X, double share) { return X + 2 * share * SIZE.x() * Vec3::UnitX(); }
Vec3 pushedThrough(const Vec3& X, double share) { return X - 1.5 * share * SIZE.x() * Vec3::UnitX(); }
Vec3 twisted(const Vec3& X, double share) {
  const Vec3 axis(0, SIZE.y() / 2, SIZE.z() / 2);
  return Eigen::AngleAxisd(4 * M_PI * share, Vec3::UnitX()) * (X - axis) + axis;
}

/// Moves the right end along its way in a number of steps, and back, and lets it settle.
void driveEnd(Matrix* matrix, const std::string& name, const Way& way) {
  Worst time, residual;
  for (const Method method : METHODS)
    for (const int steps : {200, 20}) {
      Bar bar(method, {{slab(0, 0), Vec3::Zero()}, {slab(0, SIZE.x()), Vec3::Zero()}});
      const std::vector<Vec3> X = restPositions(bar.mesh);
      double most = 0;
      int k = 0;
      bar.take(2 * steps, 0, [&] {
        ++k;
        const double share = (k <= steps ? k : 2 * steps - k) / static_cast<double>(steps);
        for (std::size_t c = 0; c < X.size(); ++c)
          if (bar.step.held()[c] == 1) bar.motion.x[c] = way(X[c], share);
        most = std::max(most, bar.elasticEnergy());
      });
      time.add(bar.timeToRecover(most));
      residual.add(bar.seen().residualIfFinite());
    }
  matrix->add(name + ": time to recover [s]", time.figure(), TIME_TO_RECOVER, RECOVERY_REASON);
  addResidual(matrix, name + ": residual on the way back", residual.figure());
}

/// What bodies keep that are put into a shape at once and let go.
struct LetGo {
  Worst growth, drift, residual, spin;

  void add(Method method, const std::function<Vec3(const Vec3&)>& shape, Worst* time) {
    Bar bar(method, {});
    for (Vec3& x : bar.motion.x) x = shape(x);
    bar.startWatching();
    time->add(bar.timeToRecover(bar.elasticEnergy()));
    growth.add(bar.seen().growth);
    drift.add(bar.seen().drift);
    residual.add(bar.seen().residualIfFinite());
    spin.add(bar.angularMomentum().norm() / (bar.mass() * SIZE.x() * 10));
  }
};

struct Shape {
  std::string name;
  Vec3 scale;
};
const std::vector<Shape> SHAPES = {{"a plane along the bar", Vec3(1, 1, 0)},
                                   {"a plane across it", Vec3(0, 1, 1)},
                                   {"a line", Vec3(1, 0, 0)},
                                   {"a point", Vec3(0, 0, 0)},
                                   {"mirrored", Vec3(-1, 1, 1)},
                                   {"inside out", Vec3(-1, -1, -1)},
                                   {"ten times the size", Vec3(10, 10, 10)}};

/// A collapsed body has many ways out; noise [m] makes neighbours choose different ones. Returns the share of runs that
/// did not recover.
double shareOfKnots(int seeds, LetGo* all) {
  int knots = 0, runs = 0;
  for (int seed = 0; seed < seeds; ++seed)
    for (const double noise : {1e-9, 1e-2})
      for (const Shape& shape : SHAPES) {
        test::Random random(100 + seed);
        Worst time;
        const auto noisy = [&](const Vec3& x) -> Vec3 { return x.cwiseProduct(shape.scale) + random.vector(noise); };
        all->add(METHODS[runs % 2], noisy, &time);
        knots += !(time.figure() <= TIME_TO_RECOVER);
        ++runs;
      }
  return static_cast<double>(knots) / runs;
}

}  // namespace

void extremeShapes(Matrix* matrix) {
  matrix->begin("Held at both ends, one is driven and brought back, in 200 and in 20 steps");
  driveEnd(matrix, "stretch to three times the length", stretched);
  driveEnd(matrix, "twist by 720°", twisted);
  driveEnd(matrix, "one end through the other", pushedThrough);

  matrix->begin("Put into a shape at once and let go");
  LetGo all;
  for (const Shape& shape : SHAPES) {
    Worst time;
    for (const Method method : METHODS)
      all.add(
          method, [&](const Vec3& x) -> Vec3 { return x.cwiseProduct(shape.scale); }, &time);
    matrix->add(shape.name + ": time to recover [s]", time.figure(), TIME_TO_RECOVER, RECOVERY_REASON);
  }
  const double knots = shareOfKnots(matrix->quick() ? 1 : 5, &all);
  addMomentum(matrix, "momentum", all.drift.figure());
  addGrowth(matrix, "energy growth", all.growth.figure());
  addResidual(matrix, "residual, once nothing is flat", all.residual.figure());
  matrix->addLimit("share of such runs with noise of 1e-9 and 1e-2 m that do not recover in time", knots, 0,
                   RECOVERY_REASON);
  matrix->addLimit("angular momentum won from rest, over mass × length × speed of sound", all.spin.figure(), 1e-6,
                   "none acts");
}

}  // namespace incision::report
