#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "incision/base/memory.h"
#include "incision/cut/cut_result.h"
#include "incision/cut/mesh_door.h"
#include "incision/solver/motion.h"
#include "incision/tool/settings.h"
#include "incision/tool/tool_contact.h"
#include "incision/tool/tool_in_step.h"
#include "incision/tool/tool_report.h"

namespace incision {

/// A command due within this [s] of a step's start takes effect before it.
inline constexpr double DUE_TOLERANCE = 1e-9;

/// What of every tool outlasts a step.
struct ToolMemory {
  std::optional<Pose> pose;  ///< of its link in the body's frame; none: it is not in place
  std::vector<Pose> path;    ///< that it was told to go, evenly in the next step
  bool active = true;        ///< it does what its kind does; otherwise it only touches
};

template <class Archive>
void serialize(Archive& archive, ToolMemory& memory) {
  auto& [pose, path, active] = memory;
  archive(pose, path, active);
}

/// A rigid instrument that another node moves: it owns its pose, its path and all that its kind does on the way. Each
/// kind is a class derived from this one.
class Tool : public Remembers {
 public:
  /// `touching` are the shapes of its link, where they touch the body; else null.
  Tool(const ToolSettings& settings, std::unique_ptr<ToolContact> touching);

  const ToolSettings& settings() const { return settings_; }
  /// Its shapes that touch; none where nothing does.
  const Obstacles& shapes() const;
  /// Its cutting edge in the frame of its link, or null.
  virtual const Edge* edge() const { return nullptr; }
  const std::optional<Pose>& pose() const { return tool_.pose; }

  /// In the next step it goes evenly along these poses to the last, where it stays. When it is not in place the first
  /// one only places it.
  void guide(const std::vector<Pose>& path);

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
  /// How its shapes touch, or null.
  const Contact* contact() const { return touching_.get(); }

  /// Of the step taken last.
  virtual ToolReport report() const;

 protected:
  /// Where the edge or whatever it works with starts from.
  virtual void start(const Pose& /*pose*/, const std::vector<Vec3>& /*x*/) {}

  /// Has gone along `way` from `first`, evenly, in a step of `time_step` [s] that ended with `motion`. Returns what
  /// ended with that.
  virtual std::optional<CutResult> act(const Pose& first, const std::vector<Pose>& way, double time_step,
                                       const Motion& motion, MeshDoor* door) = 0;

  /// What it is doing ends. Returns what became of it, if it did anything.
  virtual std::optional<CutResult> interrupt() = 0;

  ToolMemory tool_;
  ToolInStep in_step_;

 private:
  std::optional<Pose> scriptedPose(double at) const;

  ToolSettings settings_;
  std::unique_ptr<ToolContact> touching_;
  std::vector<Pose> way_;  // of the step: the path, and where the scene has it at the end
};

}  // namespace incision
