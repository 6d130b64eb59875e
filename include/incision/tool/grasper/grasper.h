#pragma once

#include <memory>

#include "incision/tool/grasper/grip.h"
#include "incision/tool/grasper/mouth.h"
#include "incision/tool/jawed_tool.h"
#include "incision/tool/kinds.h"

namespace incision {

/// A tool whose jaws hold what they have closed on: what lies between them at the end of the step in which their joint
/// comes down to the angle `closed`. They let go of it when the joint has opened beyond that, and where the tool is
/// interrupted.
class Grasper : public JawedTool {
 public:
  /// `mouth` is that of the links at the angle `closed`.
  Grasper(const ToolSettings& settings, JawLinks links, Mouth mouth, const Materials& materials, const CutMesh& mesh,
          Touching touching);

  std::vector<Coupler*> couplers() override;
  ToolReport report() const override;

 protected:
  std::optional<CutResult> act(double time_step, const Motion& motion, MeshDoor* door) override;
  std::optional<CutResult> interrupt() override;

 private:
  double closed_;
  Mouth mouth_;
  Grip grip_;
};

/// As ToolKind::make says.
std::unique_ptr<Tool> makeGrasper(const ToolSettings& settings, const Description& description,
                                  const ToolSurroundings& surroundings);

}  // namespace incision
