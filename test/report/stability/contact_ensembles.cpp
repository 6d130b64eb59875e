#include "contact_runs.h"
#include "stability.h"

namespace incision::report {
namespace {

/// What is asked of an ensemble.
struct Law {
  std::string name;
  double bound;
  std::string reason;
  double (*figure)(const Ensemble& seen);
};

const Law RISE = {"largest rise of the energy in a settled step, share of the whole", RISE_BOUND,
                  "implicit Euler and contact only take energy away",
                  [](const Ensemble& seen) { return seen.rise.figure(); }};
const Law SETTLED = {"steps that did not settle, share", 1e-3, "one in a thousand, where many pieces meet at once",
                     [](const Ensemble& seen) { return seen.unsettledShare(); }};
const Law MEDIAN = {"solves a step, median", 4, "a few Newton steps where little changes",
                    [](const Ensemble& seen) { return static_cast<double>(seen.solvesOf(0.5)); }};
const Law MOST = {"solves a step, 99 %", 12, "three times what the median may be",
                  [](const Ensemble& seen) { return static_cast<double>(seen.solvesOf(0.99)); }};
const Law OVERLAP = {"deepest overlap of fragments, of an element", 0.02, "by winding numbers: what cannot be seen",
                     [](const Ensemble& seen) { return seen.overlap.figure(); }};
const Law MOMENTUM = {"momentum, off by mass × speed", 1e-9, "gravity and the ground alone change it",
                      [](const Ensemble& seen) { return seen.momentum.figure(); }};
const Law SPIN = {"change of the angular momentum, share", 1e-9, "pieces act on each other alone",
                  [](const Ensemble& seen) { return seen.spin.figure(); }};
const Law FAILED = {"runs with a failed step", 0, "every step can be taken",
                    [](const Ensemble& seen) { return static_cast<double>(seen.failed); }};

/// What runs of one name differ in, but for seeds and friction.
struct Grid {
  std::vector<double> young_moduli, time_steps;
};

/// A run of an ensemble.
using Run = std::function<Ensemble(const Touching& touching, unsigned seed)>;

/// Takes the runs, lists what was seen of them, and asks of it what is asked.
class Ensembles {
 public:
  explicit Ensembles(Matrix* matrix) : matrix_(*matrix), seeds_(matrix->quick() ? 2 : 60) {
    matrix_.data()["seeds"] = seeds_;
  }

  /// Those of one name begin, of pieces that touch each other or the ground alone.
  void begin(const std::string& name, bool self = true) {
    name_ = name;
    self_ = self;
    together_ = Ensemble();
  }

  /// Runs each E with each Δt; in the quick run those of `few`. Friction is 0 where the seed is even, or else 0.3.
  void sweep(const Grid& all, const Grid& few, const Run& run) {
    const Grid& grid = matrix_.quick() ? few : all;
    for (const double E : grid.young_moduli)
      for (const double dt : grid.time_steps) {
        const Ensemble seen = ofSeeds(seeds_, [&](unsigned seed) {
          return run({E, dt, seed % 2 > 0 ? 0.3 : 0, self_}, seed);
        });
        nlohmann::json kind = toJson(name_, seen);
        kind.update({{"E", E}, {"dt", dt}});
        matrix_.data()["kinds"].push_back(kind);
        together_.add(seen);
      }
  }

  /// Lists what was seen of this name's runs, and the cases: of laws that are kept, and of those that are known not to
  /// be.
  void ask(const std::vector<Law>& kept, const std::vector<Law>& missed = {}) {
    matrix_.data()["ensembles"].push_back(toJson(name_, together_));
    for (const Law& law : kept) matrix_.add(name_ + ": " + law.name, law.figure(together_), law.bound, law.reason);
    for (const Law& law : missed)
      matrix_.addLimit(name_ + ": " + law.name, law.figure(together_), law.bound, law.reason);
    all_.add(together_);
  }

  /// Of the runs of every name.
  void askAll(const std::vector<Law>& kept) {
    for (const Law& law : kept) matrix_.add(law.name, law.figure(all_), law.bound, law.reason);
  }

 private:
  Matrix& matrix_;
  int seeds_;  // for each E and Δt
  std::string name_;
  bool self_ = true;
  Ensemble together_, all_;
};

void falling(Ensembles* ensembles) {
  const Grid all = {{1e4, 1e5, 1e6, 1e7, 1e8, 1e9}, {1e-3, 2e-3, 5e-3, 1e-2, 2e-2}};
  ensembles->sweep(all, {{1e4, 1e6, 1e9}, {1e-3, 2e-2}}, [](const Touching& touching, unsigned seed) {
    const int steps = touching.time_step < 2e-3 ? 30 : 20;  // it falls for 14 ms
    return runOf({fallingBlock(touching, 0.001, seed), steps, 0, touching.self && seed % 3 == 0});
  });
}

void dropped(Ensembles* ensembles) {
  ensembles->sweep({{1e4, 1e6, 1e8}, {1e-2}}, {{1e6}, {1e-2}}, [](const Touching& touching, unsigned seed) {
    return runOf({fallingBlock(touching, 0.2, seed), 40});
  });
}

void stacked(Ensembles* ensembles, const std::vector<double>& young_moduli) {
  ensembles->sweep({young_moduli, {5e-3, 1e-2}}, {{young_moduli[0]}, {1e-2}}, [](Touching touching, unsigned seed) {
    touching.friction = 0.3;
    return runOf({leaningStack(touching, seed), 60});
  });
}

void thrownDown(Ensembles* ensembles) {
  ensembles->sweep({{1e6, 1e9}, {1e-3, 1e-2}}, {{1e9}, {1e-2}}, [](const Touching& touching, unsigned seed) {
    return runOf({fallingBlock(touching, 0.001, seed), 20, 50});
  });
}

void spinning(Ensembles* ensembles) {
  ensembles->sweep({{1e5, 1e9}, {2e-3, 1e-2}}, {{1e9}, {1e-2}}, [](const Touching& touching, unsigned seed) {
    return spinningPiece(touching, seed % 4 < 2 ? 10 : 100, 30, seed);
  });
}

void cutThrough(Ensembles* ensembles) {
  ensembles->sweep({{1e5, 1e8}, {1e-2}}, {{1e5}, {1e-2}}, [](Touching touching, unsigned seed) {
    touching.friction = 0.3;
    return runOf({bladeThroughPieces(touching, seed), 45});
  });
}

}  // namespace

void contactEnsembles(Matrix* matrix) {
  Ensembles ensembles(matrix);
  matrix->begin("Contact: blocks that fall to pieces, E from 1e4 to 1e9 Pa × Δt from 1 to 20 ms");
  ensembles.begin("falling");
  falling(&ensembles);
  ensembles.ask({}, {RISE, MOST, OVERLAP});
  ensembles.begin("falling, ground alone", false);
  falling(&ensembles);
  ensembles.ask({RISE}, {MOST});
  matrix->begin("Contact: pieces that are dropped, stand, are thrown down, spin and are cut");
  ensembles.begin("dropped from 0.2 m");
  dropped(&ensembles);
  ensembles.ask({RISE}, {MOST, OVERLAP});
  ensembles.begin("stacks, E of 1e7 and 1e9 Pa");
  stacked(&ensembles, {1e7, 1e9});
  ensembles.ask({RISE, MOST, OVERLAP});
  ensembles.begin("stacks, E = 1e5 Pa");
  stacked(&ensembles, {1e5});
  ensembles.ask({RISE, MOST}, {OVERLAP});
  ensembles.begin("thrown down at 50 m/s");
  thrownDown(&ensembles);
  ensembles.ask({RISE}, {SETTLED, MOST});
  ensembles.begin("one that spins between others");
  spinning(&ensembles);
  ensembles.ask({}, {RISE, MOST, SPIN});
  ensembles.begin("a blade through pieces");
  cutThrough(&ensembles);
  ensembles.ask({}, {RISE, MEDIAN, MOST});
  matrix->begin("Contact: all of these ensembles together");
  ensembles.askAll({FAILED, SETTLED, MEDIAN, MOMENTUM});
}

}  // namespace incision::report
