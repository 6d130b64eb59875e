#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "incision/body/deformable_body.h"

namespace incision {

/// A number of a body's report, or a vector.
struct Quantity {
  std::string name;
  std::variant<std::int64_t, double, Vec3> value;
  bool in_record = true;  ///< it varies from step to step, and no other tells it
};

/// All there are, after the step taken last: the one list from which the run's summary, its record and the node's state
/// take their numbers. A new number is an entry here, and for the state a field of that name.
std::vector<Quantity> quantitiesOf(const DeformableBody& body, const StepResult& last_step);
std::vector<Quantity> quantitiesOf(const BodyCounts& counts, const BodyMotion& motion, std::int64_t unsettled_steps,
                                   const StepResult& last_step);

/// What the body does to each clamp, to the ground and to each link of the obstacles, where these wrenches are wanted:
/// `clamp_0_force`, `clamp_0_torque`, …, `ground_force`, `obstacle_0_force`, …. For the record alone.
std::vector<Quantity> wrenchQuantitiesOf(const DeformableBody& body);

/// What the tissue does to a tool, in the frame of its link and about that link's origin: `force`, `torque`; of one
/// with an edge how far it has cut: `depth`, `area`; of one with a jaw `jaw`, `jaw_torque`, `gripped`.
std::vector<Quantity> toolQuantitiesOf(const DeformableBody& body, std::size_t tool, const StepResult& last_step);

/// 16 digits, for hashes: as a number, readers of JSON keep only 53 bits.
std::string hexadecimal(std::uint64_t value);

/// What the body is before its first step, in a line for people: its size, where it lies, its mass, what holds it, its
/// regions and its tools.
std::string describe(const DeformableBody& body);

}  // namespace incision
