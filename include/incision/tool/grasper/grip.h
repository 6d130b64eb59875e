#pragma once

#include <vector>

#include "incision/fem/materials.h"
#include "incision/solver/coupler.h"
#include "incision/tool/grasper/grip_points.h"
#include "incision/tool/tool_in_step.h"

namespace incision {

/// What of a grip outlasts a step.
struct GripMemory {
  std::vector<GripPoint> points;  ///< those that are held still
  int taken = 0;                  ///< how many they were when the jaws closed
};

template <class Archive>
void serialize(Archive& archive, GripMemory& memory) {
  auto& [points, taken] = memory;
  archive(points, taken);
}

/// The grip of closed jaws on what lies between them: springs from points of the material to the tool's link. Each
/// carries its point along with k s, s being how far the point is from where it is held, until that reaches the
/// point's even share of the largest force there may be; then the point slips along with just this force. A point
/// that has slipped out of the mouth is let go, and what the others can hold together is so much less.
///
/// In a step a spring is stiff as the tissue in the mouth is, times GRIP_STIFFNESS, and no stiffer than it takes to
/// move what hangs on it.
class Grip : public WithMemory<Coupler, GripMemory> {
 public:
  /// `largest` force [N] of all points together. `mouth`, the tool and the materials must outlive this.
  Grip(double largest, const Mouth& mouth, ToolInStep* tool, const Materials& materials);

  /// The jaws have closed, with the tool's link at `link` and the copies at `x` [m]: takes what lies between them, and
  /// holds it where it is, so that there is no force at first.
  void close(const Pose& link, const std::vector<Vec3>& x, const CutMesh& mesh);
  /// Lets go of all.
  void open() { memory_ = GripMemory(); }

  /// The most force with which it can hold what it has [N].
  double strength() const { return share() * static_cast<double>(memory_.points.size()); }

  void changed(const CutMesh& mesh) override;
  bool begin(const StepStart& start, std::vector<Spring>* springs) override;
  void update(Span<const Vec3> moved, Span<Spring> springs) override;
  void accept(const StepSpan& span, Span<const Vec3> moved, const Motion& end, const Wrench& felt) override;
  bool hasOtherEnd() const override { return true; }

 private:
  /// A point in this step.
  struct Pull {
    Vec3 anchor;       // in the frame of the tool's link [m]
    Vec3 slip;         // how far the anchor is from the point when the step starts [m]
    Vec3 drift;        // of the anchor in the step [m]
    double stiffness;  // [N/m]
  };
  /// A point's state at a trial.
  struct Trial {
    Vec3 slip;      // [m]
    double secant;  // force over slip [N/m]
    bool slips;
  };

  double share() const { return memory_.taken > 0 ? largest_ / memory_.taken : 0; }
  void findStiffness(const StepStart& start, Span<Spring> springs);
  Trial tryAt(const Pull& pull, const Vec3& moved) const;

  double largest_;
  const Mouth& mouth_;
  ToolInStep* tool_;
  const Materials& materials_;
  // Of this step:
  std::vector<Pull> pulls_;    // of each point
  std::vector<double> crowd_;  // weights of all points on each copy; zero between steps
  std::vector<int> on_piece_;  // points on each piece; zero between steps
};

}  // namespace incision
