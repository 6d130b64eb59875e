// How a body is saved and restored.
#include <ostream>

#include "body_state.h"
#include "incision/base/input_error.h"

namespace incision {
/// What bytes and body must have alike for one to be read by the other.
std::array<std::int64_t, 7> DeformableBody::State::outline() const {
  return {static_cast<std::int64_t>(mesh.mesh().nodes.size()),
          static_cast<std::int64_t>(mesh.mesh().elements.size()),
          static_cast<std::int64_t>(obstacles.links.size()),
          static_cast<std::int64_t>(scene.boundary.size()),
          static_cast<std::int64_t>(own_couplers.size()),
          static_cast<std::int64_t>(tools.size()),
          growth.has_value()};
}

void DeformableBody::State::write(const BodyMemory& memory, ArchiveWriter* archive) const {
  (*archive)(outline(), memory);
  couplers.write(memory.step.couplers, archive);
  for (std::size_t i = 0; i < tools.size(); ++i) tools[i]->write(memory.step.tools[i], archive);
}

BodyMemory DeformableBody::State::read(ArchiveReader* archive) const {
  const auto own = outline();
  auto saved = own;
  (*archive)(saved);
  if (saved != own)
    throw InputError("the saved body has " + std::to_string(saved[0]) + " nodes and " + std::to_string(saved[1]) +
                     " elements, and is not of this scene, whose mesh has " + std::to_string(own[0]) + " and " +
                     std::to_string(own[1]));
  BodyMemory memory;
  memory.live.threads = live.threads;
  (*archive)(memory);
  archive->limits = mesh.check(memory.mesh);
  archive->limits.regions = static_cast<int>(scene.body.regions.size()) + 1;
  check(memory, archive->limits);
  memory.step.couplers = couplers.read(archive);
  for (const auto& tool : tools) memory.step.tools.push_back(tool->read(archive));
  return memory;
}

void DeformableBody::State::check(const BodyMemory& memory, const MemoryLimits& limits) const {
  using incision::check;
  // Beyond this a count of steps is no longer exact as a time.
  constexpr std::int64_t LAST = std::int64_t{1} << 53;
  require(memory.steps >= 0 && memory.steps < LAST, "it has taken steps that nobody can count");
  require(memory.unsettled_steps >= 0 && memory.unsettled_steps <= memory.steps,
          "it has settled in less than no steps");
  require(memory.fractured_steps >= 0 && memory.fractured_steps <= memory.steps + 1, "it breaks at another step");
  check(memory.live, limits);
  require(memory.cuts_done <= cuts.size(), "it has done more cuts than the scene has");
  require(memory.growth.has_value() == growth.has_value(), "it breaks otherwise than the scene says");
  if (memory.growth) check(*memory.growth, limits);
  require(memory.obstacles.size() == obstacles.links.size(), "its obstacles are others");
  for (const RigidMotion& link : memory.obstacles) check(link, limits);
  require(memory.clamps.size() == scene.boundary.size(), "its clamps are others");
  for (const ClampMotion& clamp : memory.clamps) {
    if (clamp.first) check(*clamp.first, limits);
    check(clamp.in_step, limits);
  }
  check(memory.step.motion, limits);
  check(memory.step.step, limits);
  check(memory.step.last_steps, limits);
}

void DeformableBody::save(std::ostream& out) const {
  ArchiveWriter archive(out);
  state_->write(state_->sound().keep(), &archive);
}

void DeformableBody::restore(std::string_view bytes) {
  ArchiveReader archive(bytes);
  const BodyMemory memory = state_->read(&archive);
  if (archive.left() > 0)
    throw InputError("the saved body is followed by " + std::to_string(archive.left()) + " bytes");
  state_->replace(memory, memory.live);
}

}  // namespace incision
