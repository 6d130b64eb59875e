#pragma once

#include <vector>

#include "incision/base/memory_limits.h"
#include "incision/fem/materials.h"
#include "incision/solver/coupler.h"
#include "incision/tool/grasper/grip_points.h"
#include "incision/tool/tool_in_step.h"

namespace incision {

/// What of a grip outlasts a step.
struct GripMemory {
  std::vector<GripPoint> points;  ///< that hold something still
  int taken = 0;                  ///< how many there were when the jaws closed
};

template <class Archive>
void serialize(Archive& archive, GripMemory& memory) {
  auto& [points, taken] = memory;
  archive(points, taken);
}

void check(const GripMemory& memory, const MemoryLimits& limits);

/// The grip of closed jaws on what lies between them: springs between places in the mouth, the anchors, and the
/// material that is there. Each carries its material along with k s, s being how far the anchor is before it, until
/// that reaches the anchor's even share of the largest force there may be: then the material slips through the mouth
/// against just this force, and the anchor holds what comes to be there. An anchor from which the material has slipped
/// away is done with, and what the others can hold together is so much less.
///
/// In a step a spring is stiff as the tissue in the mouth is, times GRIP_STIFFNESS, and no stiffer than it takes to
/// move what hangs on it.
class Grip : public WithMemory<Coupler, GripMemory> {
 public:
  /// `largest` force [N] of all anchors together. All that is referred to must outlive this.
  Grip(double largest, const Mouth& mouth, ToolInStep* tool, const Materials& materials, const CutMesh& mesh);

  /// The jaws have closed, with the tool's link at `link` and the copies at `x` [m]: takes what lies between them, and
  /// holds it where it is, so that there is no force at first.
  void close(const Pose& link, const std::vector<Vec3>& x);
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
    Vec3 end;          // of the spring in the frame of the tool's link [m]
    Vec3 slip;         // how far the end is before the material when the step starts [m]
    Vec3 drift;        // of the end in the step [m]
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
  void letSlip(const std::vector<Vec3>& x);
  Trial tryAt(const Pull& pull, const Vec3& moved) const;

  double largest_;
  const Mouth& mouth_;
  ToolInStep* tool_;
  const Materials& materials_;
  const CutMesh& mesh_;
  // Of this step:
  std::vector<Pull> pulls_;                          // of each point
  std::vector<double> crowd_;                        // weights of all points on each copy; zero between steps
  std::vector<std::size_t> slipping_;                // anchors whose material slips,
  std::vector<Vec3> slipped_to_;                     // and where what they hold then is [m],
  std::vector<std::optional<MaterialPoint>> found_;  // which is this
  std::vector<int> on_piece_;                        // points on each piece; zero between steps
};

}  // namespace incision
