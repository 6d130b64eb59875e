#pragma once

#include <vector>

#include "incision/contact/fragments.h"
#include "incision/contact/obstacle_contacts.h"
#include "incision/contact/settings.h"
#include "incision/solver/implicit_step.h"

namespace incision {

/// What touched in a step.
struct ContactReport {
  int count = 0;       ///< points that were pressed
  double deepest = 0;  ///< largest depth of one of them at the end of the step [m]
  double energy = 0;   ///< in the springs that press and drag [J]
};

/// Contact of a body with obstacles and with itself, implicit in the step. At each place where a point may touch a
/// plane with normal n the force on the point is, for the motion in the step Δy = Δt ẏ less the partner's,
///   −k (g + n·Δy) n  where that presses,
/// and tangentially −k_t (s + Δy_t) up to μ times the pressure. The drag s is kept from step to step, so what sticks
/// does not creep; there is no restitution.
class Contact {
 public:
  Contact(const ContactSettings& settings, Obstacles obstacles, double young_modulus, int threads);

  /// Before the first step and after a cut. `surface` must live until the next call; `piece` of each copy.
  void surfaceChanged(const Surface& surface, const CutMesh& mesh, const std::vector<int>& piece);

  /// Finds what may touch in a step of `time_step` [s] from here.
  void begin(const Motion& motion, double time_step, const LinkMotion& links);

  /// Whether `begin` found anything.
  bool mayTouch() const { return !candidates_.empty(); }

  /// As Couple says, but appends: the contacts that press at these velocities.
  bool update(double time_step, const std::vector<Vec3>& v_end, std::vector<Coupling>* couplings);

  /// Takes the step as done, with these velocities at its end.
  ContactReport accept(double time_step, const std::vector<Vec3>& v_end);

  /// Forgets what touched.
  void reset() { touches_.clear(); }

  const Obstacles& obstacles() const { return obstacles_; }

 private:
  /// A candidate's state at a trial.
  struct Trial {
    double gap;         ///< at the end of the step, as the force takes it [m]
    Vec3 slip;          ///< s + Δy_t [m]
    double tangential;  ///< k_t, or less where it slides [N/m]
    bool presses;
  };
  Trial tryAt(const Candidate& candidate, double time_step, const std::vector<Vec3>& v_end) const;
  double frictionOf(const Candidate& candidate) const;
  void recall(double time_step);
  int orderOf(int sample) const;

  ContactSettings settings_;
  Obstacles obstacles_;
  double young_modulus_;  // [Pa]
  int threads_;
  ContactSurface surface_;
  FragmentFinder fragments_;
  std::vector<Candidate> candidates_;  // by partner and sample
  std::vector<Trial> trials_, used_;   // of each; used_ is what the last couplings stand for
  std::vector<Touch> touches_;         // by partner and sample
  std::vector<Vec3> x_, v_;            // of the surface's vertices
};

}  // namespace incision
