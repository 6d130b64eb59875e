#include "incision/tool/grasper/grasper.h"

#include <sstream>
#include <utility>

#include "incision/base/input_error.h"

namespace incision {
namespace {

/// Throws where the jaws never get to the angle, or never beyond.
void checkClosed(double closed, const ToolSettings& settings, const JawLinks& links, const Description& description) {
  if (!links.limits()) return;
  const auto [lower, upper] = *links.limits();
  if (closed >= lower && closed < upper) return;
  std::ostringstream reason;
  reason << jointInMessage(description.name, settings.jaw->joint) << ": closed at " << closed << " (allowed: from "
         << lower << " to less than " << upper << ", its limits)";
  throw InputError(reason.str());
}

void checkRoom(double closed, const ToolSettings& settings, const Mouth& mouth, const Description& description) {
  if (!mouth.points().empty()) return;
  std::ostringstream reason;
  reason << jointInMessage(description.name, settings.jaw->joint) << ": closed at " << closed
         << ", where there is no room between the jaws (allowed: an angle at which there is some)";
  throw InputError(reason.str());
}

}  // namespace

Grasper::Grasper(const ToolSettings& settings, JawLinks links, Mouth mouth, const Materials& materials,
                 const CutMesh& mesh, Touching touching)
    : JawedTool(settings, std::move(links), std::move(touching)),
      closed_(std::get<GrasperSettings>(settings.kind).closed),
      mouth_(std::move(mouth)),
      grip_(std::get<GrasperSettings>(settings.kind).grip, mouth_, &in_step_, materials, mesh) {}

std::vector<Coupler*> Grasper::couplers() {
  std::vector<Coupler*> list = Tool::couplers();
  list.push_back(&grip_);
  return list;
}

ToolReport Grasper::report() const {
  ToolReport report = JawedTool::report();
  report.gripped = grip_.strength();
  return report;
}

/// Jaws that were closed already, as where a tool is put on the body, hold nothing.
std::optional<CutResult> Grasper::act(double /*time_step*/, const Motion& motion, MeshDoor* /*door*/) {
  if (in_step_.jaw_to > closed_)
    grip_.open();
  else if (in_step_.jaw_from > closed_)
    grip_.close(in_step_.groups[0].to, motion.x);
  return std::nullopt;
}

std::optional<CutResult> Grasper::interrupt() {
  grip_.open();
  return std::nullopt;
}

std::unique_ptr<Tool> makeGrasper(const ToolSettings& settings, const Description& description,
                                  const ToolSurroundings& surroundings) {
  const double closed = std::get<GrasperSettings>(settings.kind).closed;
  JawLinks links = jawLinksOf(settings, description);
  checkClosed(closed, settings, links, description);
  Mouth mouth(links, closed);
  checkRoom(closed, settings, mouth, description);
  Touching touching = jawTouching(settings, links, {}, surroundings.skin);
  return std::make_unique<Grasper>(settings, std::move(links), std::move(mouth), surroundings.materials,
                                   surroundings.mesh, std::move(touching));
}

}  // namespace incision
