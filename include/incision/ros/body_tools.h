#pragma once

#include <cassert>
#include <optional>
#include <vector>

#include "incision/body/deformable_body.h"

/// The body's tools by their index. The body still has one at most, and its index is 0.
namespace incision::body_tools {

inline const ToolReport& report(const StepResult& step, [[maybe_unused]] int tool) {
  assert(tool == 0);
  return step.tool;
}

inline void guide(DeformableBody* body, [[maybe_unused]] int tool, const std::vector<Pose>& path) {
  assert(tool == 0);
  body->guideTool(path);
}

inline std::optional<CutResult> place(DeformableBody* body, [[maybe_unused]] int tool, const Pose& pose) {
  assert(tool == 0);
  return body->placeTool(pose);
}

inline std::optional<CutResult> lift(DeformableBody* body, [[maybe_unused]] int tool) {
  assert(tool == 0);
  return body->liftTool();
}

inline std::optional<CutResult> activate(DeformableBody* body, [[maybe_unused]] int tool, bool on) {
  assert(tool == 0);
  return body->activateTool(on);
}

inline const std::optional<Pose>& pose(const DeformableBody& body, [[maybe_unused]] int tool) {
  assert(tool == 0);
  return body.toolPose();
}

/// Its cutting edge, in the frame of its link.
inline Edge edge(const DeformableBody& body, [[maybe_unused]] int tool, const Descriptions& descriptions) {
  assert(tool == 0);
  const ToolSettings& settings = *body.scene().tool;
  return bladeEdge(settings, descriptions.tool, settings.description);
}

/// Whether the shape is one of this tool's.
inline bool has(const Obstacles& obstacles, [[maybe_unused]] int tool, const Obstacle& shape) {
  assert(tool == 0);
  return obstacles.isTool(shape);
}

}  // namespace incision::body_tools
