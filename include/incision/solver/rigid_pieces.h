#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "incision/fem/assembly.h"
#include "incision/solver/motion.h"

namespace incision {

/// What a step starts from. A step of length h adds Δv to
///   v ← v̂ + u + Δv,  x ← x̂ + h (u + Δv).
struct StepBase {
  std::vector<Vec3> x;  ///< x̂: where the copies are after the rigid motion alone [m]
  std::vector<Vec3> v;  ///< v̂: what the rigid motion moves them with at the step's end [m/s]
  std::vector<Vec3> u;  ///< their velocity beside the rigid motion [m/s]
};

/// How far pieces that couplers act on may turn in a step, at the rate that they start with [rad].
struct TurnLimits {
  double most;     ///< so far they are let turn
  double refused;  ///< a step in which one turns farther is not taken
};

/// The rigid motion of free pieces. A step linearised about its start leaves the circle on its tangent; so each piece
/// that no clamp holds is first moved as the rigid body with its mass, momentum and spin, and the equation of the step
/// has only what deforms on top. Pieces that are held, and all pieces without warping, have x̂ = x, v̂ = 0, u = v.
class RigidPieces {
 public:
  /// Before use and after every change of the pieces: the piece of each copy, how many there are, and the clamp of each
  /// copy or −1.
  void topologyChanged(const std::vector<int>& piece, int pieces, const std::vector<int>& held, bool warping);

  /// The base of a step of implicit Euler of `time_step` [s].
  void euler(const Assembly& assembly, const Motion& motion, double time_step, StepBase* base);

  /// The base of a step of implicit Euler from which steps of second order may begin: to that order it counts what the
  /// piece is stretched by as it spins, and Coriolis' force.
  void firstOfSecondOrder(const Assembly& assembly, const Motion& motion, double time_step, StepBase* base);

  /// The base of a step of second order: of length 2/3 `time_step`, ending `time_step` after `now`, which came
  /// `time_step` after `before`. Pieces that are held have
  ///   x̂ = x_n + (x_n − x_{n−1})/3,  û = v_n + (v_n − v_{n−1})/3,
  /// and free ones likewise in the frame that goes with their rigid motion.
  void secondOrder(const Assembly& assembly, const Motion& now, const Motion& before, double time_step, StepBase* base);

  /// Gives the free pieces these impulses on copies [N s], as if at the start, when the copies were at `x` [m]: the
  /// base is then that of the momentum and spin which they leave. `given` is what each copy has of these [N s]. A piece
  /// that would turn farther than `limits.most` gets a share of its impulses. Returns false, with nothing of use in the
  /// base, where one turns farther than is taken.
  bool kick(const Assembly& assembly, const std::vector<Vec3>& x, const std::vector<Vec3>& impulses, StepBase* base,
            std::vector<Vec3>* given, const TurnLimits& limits);

  /// The Δv of a step of implicit Euler from copies at `x` [m], of which couplers have given the impulses [N s]. Pieces
  /// that couplers have acted on go as if they had done so at the start: as the rigid body with the momentum and spin
  /// that it has then, and with what deforms turned along. So a piece that an impact sets spinning does not leave the
  /// circle on its tangent either, and what couplers do is no more than the energy that they have: the chord of a turn
  /// is shorter than its tangent at the start. A piece that would turn farther than `limits.most` loses spin. Returns
  /// false where one turns farther than is taken.
  bool takeChange(const Assembly& assembly, const StepBase& base, const std::vector<Vec3>& dv,
                  const std::vector<Vec3>& impulses, const std::vector<Vec3>& x, const TurnLimits& limits);
  /// Where copies end with the change taken last: the base and Δv but for the pieces said above.
  void finish(const StepBase& base, const std::vector<Vec3>& dv, Motion* motion) const;

  std::size_t pieces() const { return free_.size(); }
  int pieceOf(std::size_t copy) const { return piece_[copy]; }
  bool isFree(std::size_t copy) const { return free_[static_cast<std::size_t>(piece_[copy])]; }
  /// Of a free piece, in the base found last.
  double massOf(int piece) const { return bodies_[static_cast<std::size_t>(piece)].mass; }
  Vec3 centreOf(int piece) const {
    const Body& body = bodies_[static_cast<std::size_t>(piece)];
    return body.centre + time_step_ * body.velocity;
  }
  Mat3 inertiaOf(int piece) const {
    const Mat3& Q = turns_[static_cast<std::size_t>(piece)].rotation;
    return Q * bodies_[static_cast<std::size_t>(piece)].inertia * Q.transpose();
  }

 private:
  /// A piece as a rigid body, in the masses that the equation has.
  struct Body {
    double mass;
    Vec3 centre, velocity, spin;  // c [m], V [m/s], L [kg m²/s]
    Mat3 inertia;                 // J [kg m²]
    bool is_kicked;               // couplers' impulses are in it
    Mat3 symmetricInertia() const { return 0.5 * (inertia + inertia.transpose()); }
  };
  /// A rigid motion over a step.
  struct Turn {
    Mat3 inverse_inertia;  // J⁺ at its start [1/(kg m²)]
    Mat3 rotation;         // Q
    Vec3 rate, ends;       // ω at its start and at its end [1/s]
    Vec3 change;           // dω/dt at its end [1/s²]

    /// What a spin L adds to the rate at its end [1/s].
    Vec3 rateOf(const Vec3& spin) const { return rotation * (inverse_inertia * (rotation.transpose() * spin)); }

    /// What its frame accelerates a point by that is at r and moves by w in it, at its end [m/s²].
    Vec3 accelerationAt(const Vec3& r, const Vec3& w) const {
      return change.cross(r) + ends.cross(ends.cross(r) + 2 * w);
    }
  };

  /// What a piece gets in a step.
  struct Kick {
    bool is_coupled = false;
    Vec3 momentum = Vec3::Zero(), spin = Vec3::Zero();  // by Δv at x̂
    Vec3 at_start = Vec3::Zero();                       // of the couplers' impulses, spin by the levers at the start
    Vec3 at_end = Vec3::Zero();                         // by those at x̂
    Vec3 velocity = Vec3::Zero(), rate = Vec3::Zero();  // rigid part of Δv at x̂
  };

  Vec3 moveAlong(std::size_t copy, const Vec3& x, StepBase* base) const;
  void measure(const Assembly& assembly, const Motion& motion);
  void findKicks(const Assembly& assembly, const StepBase& base, const std::vector<Vec3>& dv,
                 const std::vector<Vec3>& impulses, const std::vector<Vec3>& x);
  static Turn turnOf(const Body& body, double time_step);
  static double angleOf(const Body& body, double time_step);
  void findTurns(double time_step, std::vector<Turn>* turns) const;

  std::vector<int> piece_;  // of each copy
  std::vector<char> free_;  // of each piece
  bool any_free_ = false;
  double time_step_ = 0;
  // Of each piece: as the base has it, as it is with all that couplers do, and turning backwards.
  std::vector<Body> bodies_, kicked_;
  std::vector<Turn> turns_, kicked_turns_, turns_back_;
  std::vector<Vec3> mass_x_, mass_v_;  // M x, M v, where the mass is consistent
  std::vector<Kick> kicks_;
};

}  // namespace incision
