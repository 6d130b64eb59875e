#include "incision/body/quantities.h"

#include <cinttypes>
#include <cstdio>
#include <iomanip>
#include <sstream>

#include "incision/base/printable.h"
#include "incision/base/yaml_reader.h"
#include "incision/tool/kinds.h"

namespace incision {

std::vector<Quantity> quantitiesOf(const DeformableBody& body, const StepResult& last_step) {
  return quantitiesOf(body.counts(), body.motion(), body.unsettledSteps(), last_step);
}

std::vector<Quantity> quantitiesOf(const BodyCounts& counts, const BodyMotion& motion, std::int64_t unsettled_steps,
                                   const StepResult& last_step) {
  const auto count = [](const char* name, std::int64_t value, bool in_record = true) {
    return Quantity{name, value, in_record};
  };
  return {count("nodes", counts.nodes, false),
          count("held_nodes", counts.held_nodes, false),
          count("elements", counts.elements, false),
          count("crack_elements", counts.crack_elements),
          count("parts", counts.parts),
          count("copies", counts.copies),
          count("dofs", counts.dofs, false),
          count("cracks", counts.cracks),
          count("pieces", counts.pieces),
          {"mass", motion.mass, false},
          {"momentum", motion.momentum},
          {"kinetic_energy", motion.kinetic_energy},
          {"elastic_energy", motion.elastic_energy},
          {"potential_energy", motion.potential_energy},
          {"contact_energy", last_step.contact.energy},
          {"max_displacement", motion.max_displacement},
          count("iterations", last_step.iterations),
          {"residual", last_step.residual},
          count("solves", last_step.solves),
          count("unsettled_steps", unsettled_steps)};
}

std::vector<Quantity> wrenchQuantitiesOf(const DeformableBody& body) {
  std::vector<Quantity> quantities;
  const auto add = [&](const std::string& name, const Wrench& wrench) {
    quantities.push_back({name + "_force", wrench.force});
    quantities.push_back({name + "_torque", wrench.torque});
  };
  const auto addEach = [&](const std::string& name, const std::vector<Wrench>& wrenches) {
    for (std::size_t i = 0; i < wrenches.size(); ++i) add(name + std::to_string(i), wrenches[i]);
  };
  const BodyWrenches& wrenches = body.wrenches();
  addEach("clamp_", wrenches.clamps);
  if (body.scene().contact && body.scene().contact->ground) add("ground", wrenches.ground);
  addEach("obstacle_", wrenches.obstacles);
  return quantities;
}

std::vector<Quantity> toolQuantitiesOf(const DeformableBody& body, std::size_t tool, const StepResult& last_step) {
  const ToolReport report = tool < last_step.tools.size() ? last_step.tools[tool] : ToolReport();
  std::vector<Quantity> quantities = {{"force", report.force}, {"torque", report.torque}};
  if (!body.toolForm(tool).edges.empty()) {
    quantities.push_back({"depth", report.depth});
    quantities.push_back({"area", report.stroke_area});
  }
  if (body.scene().tools[tool].jaw) {
    quantities.push_back({"jaw", report.jaw});
    quantities.push_back({"jaw_torque", report.jaw_torque});
    quantities.push_back({"gripped", report.gripped});
  }
  return quantities;
}

std::string hexadecimal(std::uint64_t value) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016" PRIx64, value);
  return digits;
}

std::string describe(const DeformableBody& body) {
  const BodyCounts counts = body.counts();
  const auto& [low, high] = body.bounds();
  std::ostringstream line;
  line << std::setprecision(4) << "a body of " << counts.elements << " elements in frame \"" << body.scene().body.frame
       << "\", from (" << low.x() << ", " << low.y() << ", " << low.z() << ") to (" << high.x() << ", " << high.y()
       << ", " << high.z() << ") m, of " << body.motion().mass << " kg, " << counts.held_nodes << " of its "
       << counts.nodes << " nodes held";
  const Regions& regions = body.materials().regions();
  std::vector<std::string> names;
  for (int r = 1; r < regions.count(); ++r) names.push_back(printable(regions.name(r)));
  if (!names.empty()) line << "; regions: " << joined(names);
  names.clear();
  for (const ToolSettings& tool : body.scene().tools) names.push_back(tool.name + " (" + kindOf(tool).name + ")");
  if (!names.empty()) line << "; tools: " << joined(names);
  return line.str();
}

}  // namespace incision
