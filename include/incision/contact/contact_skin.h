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

  /// A step starts: takes over the surface, where it has changed, and places it.
  void begin(const StepStart& start);

  const ContactSurface& surface() const { return surface_; }
  const std::vector<Vec3>& x() const { return x_; }  ///< of the vertices [m]
  /// How far they go in the step if nothing new acts [m].
  const std::vector<Vec3>& ahead() const { return ahead_; }
  int threads() const { return threads_; }

  /// Of the surface that was taken over last; 0: none yet.
  std::uint64_t version() const { return version_; }

 private:
  const CurrentSurface& current_;
  const Materials& materials_;
  int threads_;
  ContactSurface surface_;
  std::uint64_t version_ = 0;
  std::vector<Vec3> x_, ahead_;
};

}  // namespace incision
