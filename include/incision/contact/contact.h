#pragma once

#include <vector>

#include "incision/contact/candidate.h"
#include "incision/contact/contact_point.h"
#include "incision/contact/contact_report.h"
#include "incision/contact/contact_skin.h"
#include "incision/contact/legacy.h"
#include "incision/solver/coupler.h"

namespace incision {

/// Contact of a body's surface with something. At each place where a point may touch a plane with normal n the force on
/// the point is, for the displacement in the step Δy less the partner's,
///   −k (g + n·Δy) n  where that presses,
/// and tangentially −k_t (s + Δy_t) up to μ times the pressure. The drag s is kept from step to step, so what sticks
/// does not creep; there is no restitution. Derived classes say what the body may touch.
class Contact : public WithMemory<Coupler, std::vector<Touch>> {
 public:
  /// `friction` is Coulomb's coefficient μ. `skin` must outlive this.
  Contact(double friction, ContactSkin* skin) : friction_(friction), skin_(skin) {}

  void changed(const CutMesh& /*mesh*/) override {}
  bool begin(const StepStart& start, std::vector<Spring>* springs) override;
  void takeBounds(Span<const Vec3> moved, Span<const double> share) override;
  void update(Span<const Vec3> moved, Span<Spring> springs) override;
  void accept(const StepSpan& span, Span<const Vec3> moved, const Motion& end, const Wrench& felt) override;
  void recall(const std::any& kept) override;

  /// Of the step taken last.
  const ContactReport& report() const { return report_; }

  /// Adds what pressed in a step of `time` [s] that has been taken: by how far the springs' points went, by the
  /// impulses [N s] on the body, and by where the copies are at its end [m]. `tool` is whose shapes it touches.
  void addPoints(Span<const Vec3> moved, Span<const Vec3> impulses, double time, int tool, const std::vector<Vec3>& x,
                 std::vector<ContactPoint>* points) const;

 protected:
  /// Whether anything can be touched in this step at all: where not, the skin is not even placed.
  virtual bool isThere() const { return true; }

  /// Finds what may touch in a step from here: candidates in the order of their partners, and then of their samples.
  virtual void find(const ContactSkin& skin, const StepStart& start, const std::vector<Touch>& touches,
                    std::vector<Candidate>* candidates) = 0;

  const ContactSkin& skin() const { return *skin_; }

  /// Of the step, in the order of their springs.
  const std::vector<Candidate>& candidates() const { return candidates_; }

 private:
  /// What of a candidate tells whether it presses, apart from the rest: most do not, and each trial asks them all.
  struct Gap {
    Vec3 normal;
    double start;  // where nothing moves, as the force takes it [m]
    bool is_open;  // the spring was told that nothing presses and nothing drags

    /// At a trial [m].
    double at(const Vec3& moved) const { return start + normal.dot(moved); }
  };
  /// Of a candidate, in the search for the solution.
  struct Friction {
    double most;       // its bound [N]
    Vec3 slid;         // where it was last: how far it had dragged if it slid there, or zero [m]
    double steepness;  // what it resists along its way while it slides, as a share of what it does across it
  };
  Vec3 slipAt(const Candidate& candidate, const Vec3& moved) const;
  void updatePressed(int i, double gap, const Vec3& moved, Spring* spring) const;
  void findSteepness(int i, const Vec3& moved);
  void softenStiffest(const StepStart& start);
  const std::vector<Touch>& touchesOnSkin();
  void continueTouches(const std::vector<Touch>& touches, double time_step);
  Touch touchOf(const Candidate& candidate, double gap, const Vec3& moved, double most) const;

  double friction_;
  ContactSkin* skin_;
  ContactReport report_;
  std::uint64_t skin_version_ = 0;  // in which the memory numbers its samples; 0: in some other
  // Of this step:
  std::vector<Touch> renumbered_;  // the memory's touches, by partner and sample of another skin
  Legacy legacy_;
  std::vector<Candidate> candidates_;  // by partner and sample
  std::vector<Gap> gaps_;              // of each
  std::vector<Friction> frictions_;    // of each
};

}  // namespace incision
