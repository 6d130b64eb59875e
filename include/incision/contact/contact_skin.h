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
  /// How far from a vertex may be what it meets in the step, if that stands still and nothing new acts: its way and the
  /// MARGIN [m].
  double room(int vertex) const { return room_[vertex]; }
  /// Whether a ball round `centre` [m] is near enough to some vertex for that.
  bool mayMeet(const Vec3& centre, double radius) const {
    return box_.exteriorDistance(centre) <= radius + largest_room_;
  }
  int threads() const { return threads_; }
  void setThreads(int threads) { threads_ = threads; }

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
  std::vector<double> room_;  // of the vertices [m],
  double largest_room_ = 0;   // and of them all
  Eigen::AlignedBox3d box_;   // of the vertices when the step starts [m]
};

}  // namespace incision
