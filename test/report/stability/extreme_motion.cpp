#include <Eigen/Geometry>
#include <cmath>

#include "incision/contact/body_contact.h"
#include "stability.h"
#include "support/given_springs.h"
#include "support/random.h"
#include "watched.h"

namespace incision::report {
namespace {

/// A block that spins about its third axis at 10 rad/s, in steps in which it turns by an angle.
class Spinning : public Watched {
 public:
  Spinning(double young_modulus, double turn)
      : Watched(block({3, 2, 2}, Vec3(0.3, 0.2, 0.2)), settingsOf(young_modulus, turn)) {
    for (std::size_t c = 0; c < motion.x.size(); ++c)
      motion.v[c] = 10 * Vec3::UnitZ().cross(motion.x[c] - Vec3(0.15, 0.1, 0.1));
    startWatching();
  }

 private:
  static RigSettings settingsOf(double young_modulus, double turn) {
    RigSettings settings = freeBody(Method::DIRECT);
    settings.material.young_modulus = young_modulus;
    settings.solver.time_step = turn / 10;
    return settings;
  }
};

/// What is left of the angular momentum of a rigid body that fully implicit Euler steps turn, by `turn` in the first.
/// The force of a step points along its end, so 2 sin θ' = sin(θ + θ').
double leftByImplicitEuler(double turn, int steps) {
  double theta = turn;
  for (int k = 0; k < steps; ++k) {
    double next = theta;
    for (int i = 0; i < 50; ++i) next = std::asin(std::sin(theta + next) / 2);
    theta = next;
  }
  return std::sin(theta) / std::sin(turn);
}

/// A turn of more than this a step is made of short ones [rad].
constexpr double FAST_TURN = 0.3;

/// Ten turns of a block.
void spinning(Matrix* matrix) {
  nlohmann::json& rows = matrix->data()["spin"] = nlohmann::json::array();
  Worst lost, slow_or_fast, between, share_of_square, elastic;
  for (const double E : {1e6, 1e9})
    for (const double turn : {0.01, 0.03, 0.1, 0.3, 1.0}) {
      Spinning body(E, turn);
      const double L = body.angularMomentum().norm(), T = body.kineticEnergy();
      const int steps = static_cast<int>(std::ceil(20 * M_PI / turn));
      body.take(steps, 0);
      const double left = body.angularMomentum().norm() / L, growth = body.seen().kinetic_growth;
      lost.add(std::abs(1 - left));
      (turn > FAST_TURN || turn < 0.02 ? slow_or_fast : between).add(growth);
      share_of_square.add(growth / (turn * turn));
      elastic.add(body.elasticEnergy() / T);
      rows.push_back({{"E", E},
                      {"turn", turn},
                      {"left", left},
                      {"euler", leftByImplicitEuler(turn, steps)},
                      {"growth", growth},
                      {"elastic", body.elasticEnergy() / T}});
    }
  matrix->add("ten turns at 0.01 to 1 rad a step: change of angular momentum, share", lost.figure(), 1e-9,
              "none acts: the rigid motion keeps it");
  matrix->add("elastic energy over kinetic energy, up to 1 rad a step", elastic.figure(), 1e-6,
              "a step ends on the circle: a rigid body has none");
  matrix->add("growth of the kinetic energy, θ of 0.01 and of 1 rad", slow_or_fast.figure(), GROWTH_BOUND,
              "no force acts");
  matrix->addLimit("growth of the kinetic energy, θ from 0.03 to 0.3 rad", between.figure(), GROWTH_BOUND,
                   "no force acts");
  matrix->add("growth of the kinetic energy over θ², any θ", share_of_square.figure(), 0.01,
              "a turn is of second order, and the block's axes are a little askew");
}

/// A free bar under dead tension, a little askew. It turns to and fro with ω² = 12 σ/(ρL²). A step turns it on by ωΔt,
/// and takes the tension as it pulls there; so λ² − 2 (1 − s) λ + 1 − s = 0, s = (ωΔt)², is stable up to s = 4/3.
void deadTension(Matrix* matrix) {
  nlohmann::json& rows = matrix->data()["tension"] = nlohmann::json::array();
  Worst below, beyond;
  for (const double ratio : {1e-3, 1e-2, 1e-1})
    for (const double number : {0.01, 0.03, 0.06, 0.1, 0.2, 0.3, 0.5, 1.0, 3.0, 10.0}) {
      RigSettings settings = freeBody(Method::DIRECT);
      const double sigma = ratio * settings.material.young_modulus, length = 1;
      settings.solver.time_step = length * std::sqrt(number * settings.material.density / sigma);
      settings.conditions.loads = {{slab(0, length), Vec3(sigma, 0, 0), 0}, {slab(0, 0), Vec3(-sigma, 0, 0), 0}};
      Watched bar(block({8, 2, 2}, Vec3(length, 0.25, 0.25)), settings);
      for (Vec3& x : bar.motion.x) x.y() += 1e-3 * x.x();
      const auto sway = [&](int steps) {
        double most = 0;
        for (int k = 0; k < steps; ++k) {
          bar.take(1, 0);
          for (const Vec3& v : bar.motion.v) most = std::max(most, v.tail<2>().norm());
        }
        return most;
      };
      const double first = sway(10);
      sway(280);
      const double last = sway(10);
      const double growth = bar.seen().finite ? last / first : -1;
      (number < 1.0 / 9 ? below : beyond).add(growth);
      rows.push_back({{"ratio", ratio}, {"number", number}, {"growth", growth}});
    }
  matrix->add("sway after 300 steps over the first, Δt²σ/(ρL²) ≤ 0.1", below.figure(), 1,
              "stable below 1/9: ω² = 12σ/(ρL²), (ωΔt)² < 4/3");
  matrix->addLimit("the same beyond 1/9", beyond.figure(), 1, "it should not grow");
}

/// A block in two pieces hits the ground at 50 m/s.
struct Impact {
  Worst rise, depth, below;
  int failed = 0;

  void run(double young_modulus, double dt, Method method) {
    RigSettings settings = freeBody(method);
    settings.material.young_modulus = young_modulus;
    settings.solver.time_step = dt;
    const double cell = 0.05, duration = 0.3;
    Watched body(block({4, 4, 4}, Vec3::Constant(4 * cell), Vec3(0, 0, 0.02)), settings);
    body.cut(plane(Vec3(0.1, 0.1, 0.13), Vec3(0.1, 0.2, 1)));
    for (Vec3& v : body.motion.v) v = Vec3(0, 0, -50);
    ContactSettings ground;
    ground.ground = 0;
    const CurrentSurface surface(body.mesh);
    ContactSkin skin(surface, body.materials, 1);
    const Obstacles obstacles = loadObstacles(ground, "", "");
    const std::vector<RigidMotion> none;
    BodyContact contact(ground, obstacles, none, &skin);
    Couplers couplers({&contact});
    couplers.changed(body.mesh);
    const double first = body.energy();
    for (bool good = true; body.time < duration && good;) {
      good = advanceWith(&body, &couplers) && allFinite(body.motion);
      failed += !good;
      const ContactReport& report = contact.report();
      depth.add(report.deepest / cell);
      rise.add(std::max(0.0, (body.energy() + report.energy) / first - 1));
    }
    double lowest = 0;
    for (const Vec3& x : surfacePositions(surface.get(), body.motion.x)) lowest = std::min(lowest, x.z());
    below.add(-lowest / cell);
  }
};

void impact(Matrix* matrix) {
  for (const Method method : METHODS) {
    Impact hard, soft;
    for (const double dt : matrix->quick() ? std::vector<double>{1e-2} : std::vector<double>{1e-3, 1e-2}) {
      for (const double E : {1e5, 1e6, 1e7, 1e9}) hard.run(E, dt, method);
      soft.run(1e4, dt, method);
    }
    const std::string with = std::string(", ") + nameOf(method);
    matrix->add("50 m/s on the ground, E 1e5 to 1e9 Pa: failed steps" + with, hard.failed, 0,
                "every step can be taken");
    matrix->add("energy growth, contact's included" + with, hard.rise.figure(), 1e-6, "the ground does no work");
    matrix->add("deepest contact, of an element" + with, hard.depth.figure(), 1, "nothing passes through");
    matrix->add("what is below the ground after 0.3 s, of an element" + with, hard.below.figure(), 0.01,
                "it has bounced or rests");
    matrix->add("E = 1e4 Pa, 250 times less than ρv²: failed steps" + with, soft.failed, 0, "every step can be taken");
    matrix->add("the same: energy growth" + with, soft.rise.figure(), 1e-6, "the ground does no work");
  }
}

/// From none to a million seconds of stiffness damping and 1e9/s of mass damping.
void damping(Matrix* matrix) {
  for (const Method method : METHODS) {
    Worst residual, growth, drift;
    for (const double alpha : {0.0, 3.0, 1e3, 1e9})
      for (const double beta : {0.0, 1e-3, 1.0, 1e3, 1e6}) {
        RigSettings settings = freeBody(method);
        settings.material.mass_damping = alpha;
        settings.material.stiffness_damping = beta;
        Watched body(block({6, 4, 4}, Vec3(0.6, 0.4, 0.4)), settings);
        body.cut(plane(Vec3(0.31, 0.2, 0.2), Vec3(1, 0.3, 0.1)));
        throwApart(&body);
        const Vec3 momentum = body.momentum();
        body.take(50, 2);
        residual.add(body.seen().residualIfFinite());
        growth.add(body.seen().growth);
        const Vec3 expected = momentum * std::pow(1 + alpha * settings.solver.time_step, -50);
        drift.add((body.momentum() - expected).norm() / body.mass());
      }
    const std::string with = std::string(", ") + nameOf(method);
    addResidual(matrix, "damping α 0 to 1e9 1/s × β 0 to 1e6 s: residual" + with, residual.figure());
    addGrowth(matrix, "damping: energy growth" + with, growth.figure());
    addMomentum(matrix, "momentum is (1+αΔt)⁻ⁿ of the first, off by mass × 1 m/s" + with, drift.figure());
  }
}

}  // namespace

void extremeMotion(Matrix* matrix) {
  matrix->begin("Spinning");
  spinning(matrix);
  matrix->begin("Dead tension on a free bar");
  deadTension(matrix);
  matrix->begin("Impact");
  impact(matrix);
  matrix->begin("Undamped to overdamped");
  damping(matrix);
}

}  // namespace incision::report
