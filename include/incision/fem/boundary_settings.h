#pragma once

#include <string>
#include <vector>

#include "incision/mesh/place.h"
#include "incision/rigid/timed_pose.h"

namespace incision {

/// The nodes of a place move with a given velocity, or rigidly with a frame: when the frame stands at P, at
/// x = P P₀⁻¹ X, P₀ being its first pose known.
struct Clamp {
  Place place;
  Vec3 velocity = Vec3::Zero();       ///< [m/s]
  std::string frame = {};             ///< tf frame that it moves with; empty: none
  std::vector<TimedPose> poses = {};  ///< of the frame in the body's frame; between them the pose is interpolated
  std::string poses_file = {};        ///< file of the poses, where it is still to be read

  /// Whether it moves with a frame.
  bool isPosed() const { return !frame.empty() || !poses.empty(); }
};

/// Whether two clamps move their nodes as one.
bool moveAlike(const Clamp& a, const Clamp& b);

/// A load on the boundary faces of a place.
struct Load {
  Place place;
  Vec3 traction = Vec3::Zero();  ///< keeps its direction and acts on the area at rest [Pa]
  double ramp = 0;               ///< time [s] from nothing to full; 0: at once
  double pressure = 0;           ///< acts on the area as it is deformed, against its normal [Pa]
};

/// An entry of the section `boundary`. Throws InputError.
Clamp parseClamp(const YamlValue& value);

/// An entry of the section `loads`. Throws InputError.
Load parseLoad(const YamlValue& value);

}  // namespace incision
