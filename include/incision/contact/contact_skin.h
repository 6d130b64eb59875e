#pragma once

#include "incision/contact/contact_surface.h"
#include "incision/fem/materials.h"
#include "incision/solver/coupler.h"
#include "incision/surface/current_surface.h"

namespace incision {

/// The body's surface as all its contacts share it, with its vertices where they are when a step starts.
class ContactSkin {
 public:
  /// `surface` and `materials` must outlive this.
  ContactSkin(const CurrentSurface& surface, const Materials& materials, int threads)
      : current_(surface), materials_(materials), threads_(threads) {}

  /// A step starts: takes over the surface, where it has changed, and places it, unless that has been done for this
  /// start.
  void begin(const StepStart& start);

  const ContactSurface& surface() const { return surface_; }
  const std::vector<Vec3>& x() const { return x_; }  ///< of the vertices [m]
  /// How far they go in the step if nothing new acts [m].
  const std::vector<Vec3>& ahead() const { return ahead_; }
  /// Whether some vertex may come in the step to within MARGIN elements of a ball round `centre` [m], as far as nothing
  /// new acts.
  bool mayMeet(const Vec3& centre, double radius) const { return box_.exteriorDistance(centre) <= radius + room_; }
  int threads() const { return threads_; }

  /// Of the surface that was taken over last; 0: none yet.
  std::uint64_t version() const { return version_; }

 private:
  const CurrentSurface& current_;
  const Materials& materials_;
  int threads_;
  ContactSurface surface_;
  std::uint64_t version_ = 0;
  std::uint64_t placed_for_ = 0;  // serial of the start
  std::vector<Vec3> x_, ahead_;
  Eigen::AlignedBox3d box_;  // of the vertices when the step starts [m],
  double room_ = 0;          // and what any of them may go, and its margin [m]
};

}  // namespace incision
