#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "incision/base/memory.h"
#include "incision/base/memory_limits.h"
#include "incision/cut/cut_result.h"
#include "incision/cut/mesh_door.h"
#include "incision/solver/motion.h"
#include "incision/tool/settings.h"
#include "incision/tool/tool_contact.h"
#include "incision/tool/tool_form.h"
#include "incision/tool/tool_in_step.h"
#include "incision/tool/tool_report.h"

namespace incision {

/// A command due within this [s] of a step's start takes effect before it.
inline constexpr double DUE_TOLERANCE = 1e-9;

/// What of every tool outlasts a step.
struct ToolMemory {
  std::optional<Pose> pose;      ///< of its link in the body's frame; none: it is not in place
  std::vector<Pose> path;        ///< that it was told to go, evenly in the next step
  double jaw = 0;                ///< angle of its joint [rad]
  std::optional<double> jaw_to;  ///< that it was told to go to, evenly in the next step
  bool active = true;            ///< it does what its kind does; otherwise it only touches
};

template <class Archive>
void serialize(Archive& archive, ToolMemory& memory) {
  auto& [pose, path, jaw, jaw_to, active] = memory;
  archive(pose, path, jaw, jaw_to, active);
}

void check(const ToolMemory& memory, const MemoryLimits& limits);

/// Shapes of a tool that move together, with what they need to touch.
using Touching = std::vector<std::unique_ptr<ToolContact>>;

/// A rigid instrument that another node moves, or two of them on a joint: it owns its pose, its path and all that its
/// kind does on the way. Each kind that does more than touch is a class derived from this one, which overrides the
/// functions of its memory where it has more of that.
class Tool : public Remembers {
 public:
  /// `touching`: contacts of its groups, where it touches the body.
  Tool(const ToolSettings& settings, Touching touching);

  void keepIn(std::any* kept) const override { memoryIn<ToolMemory>(kept) = tool_; }
  void recall(const std::any& kept) override { tool_ = std::any_cast<const ToolMemory&>(kept); }
  void write(const std::any& kept, ArchiveWriter* archive) const override { writeKept<ToolMemory>(kept, archive); }
  std::any read(ArchiveReader* archive) const override { return readKept<ToolMemory>(archive); }

  const ToolSettings& settings() const { return settings_; }
  const std::optional<Pose>& pose() const { return tool_.pose; }
  /// Angle of its joint [rad]; 0 where it has none.
  double jaw() const { return tool_.jaw; }

  /// What moves together: its link, which is group 0, and each of its jaws.
  virtual int groups() const { return 1; }
  /// Where a group stands in the frame of the link while the joint is at an angle [rad].
  virtual Pose groupPose(int /*group*/, double /*angle*/) const { return Pose(); }
  virtual ToolForm form() const;

  /// In the next step it goes evenly along these poses to the last, where it stays. When it is not in place the first
  /// one only places it.
  void guide(const std::vector<Pose>& path);
  /// In the next step its joint turns evenly to this angle [rad], where it stays.
  void guideJaw(double angle) { tool_.jaw_to = angle; }

  /// From now on cutting takes so many times the force that was asked for, ≥ 0.
  virtual void scaleCuttingForce(double /*factor*/) {}

  /// Puts it there at once. This interrupts what it is doing, and returns what became of that, as the next two do.
  std::optional<CutResult> place(const Pose& pose);

  /// Takes it away until the next pose.
  std::optional<CutResult> lift();

  /// Whether it does what its kind does, as at first, or only touches.
  std::optional<CutResult> activate(bool active);

  /// A step of `time_step` [s] starts at `time` [s], with the copies at `x` [m]: it goes from where it is to the end of
  /// its path. May be called again for a step that has failed.
  void startStep(double time, double time_step, const std::vector<Vec3>& x);

  /// The step has been taken, from the positions that startStep had to these: it is where its path ended, and has done
  /// on the way what its kind does. Returns what ended with that, if it ended.
  std::optional<CutResult> endStep(double time_step, const Motion& motion, MeshDoor* door);

  /// What acts between it and the body. These live as long as the tool.
  virtual std::vector<Coupler*> couplers();
  /// How its groups touch; empty where nothing does.
  const Touching& touching() const { return touching_; }

  /// Of the step taken last.
  virtual ToolReport report() const;

 protected:
  /// Where the edge or whatever it works with starts from.
  virtual void start(const std::vector<Vec3>& /*x*/) {}

  /// Its groups have gone along their ways in a step of `time_step` [s] that ended with `motion`. Returns what ended
  /// with that.
  virtual std::optional<CutResult> act(double /*time_step*/, const Motion& /*motion*/, MeshDoor* /*door*/) {
    return std::nullopt;
  }

  /// What it is doing ends. Returns what became of it, if it did anything.
  virtual std::optional<CutResult> interrupt() { return std::nullopt; }

  /// The poses of each group in the step, from that at which it starts; each takes as long as any other. One alone
  /// where nothing moves.
  const std::vector<std::vector<Pose>>& ways() const { return ways_; }

  /// Two points of the link that are as far as any shape reaches while the joint is where it is.
  Edge extentOf(const Obstacles& shapes) const;

  ToolMemory tool_;
  ToolInStep in_step_;

 private:
  std::optional<Pose> scriptedPose(double at) const;
  std::optional<double> scriptedJaw(double at) const;
  void startJaw(double time, double time_step);
  void findWays(const Pose& from);

  ToolSettings settings_;
  Touching touching_;
  // Of the step:
  std::vector<Pose> way_;                // of the link: the path, and where the scene has it at the end
  std::vector<std::vector<Pose>> ways_;  // of each group, from where it starts
};

}  // namespace incision
