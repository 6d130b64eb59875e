#include "incision/body/quantities.h"

namespace incision {

std::vector<Quantity> quantitiesOf(const DeformableBody& body, const StepResult& last_step) {
  const BodyCounts counts = body.counts();
  const BodyMotion motion = body.motion();
  const auto count = [](const char* name, std::int64_t value, bool in_record = true) {
    return Quantity{name, value, in_record};
  };
  return {count("nodes", counts.nodes, false),
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
          count("unsettled_steps", body.unsettledSteps())};
}

}  // namespace incision
