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
  (*archive)(memory);
  memory.step.couplers = couplers.read(archive);
  for (const auto& tool : tools) memory.step.tools.push_back(tool->read(archive));
  return memory;
}

void DeformableBody::save(std::ostream& out) const {
  ArchiveWriter archive(out);
  state_->write(state_->keep(), &archive);
}

void DeformableBody::restore(std::string_view bytes) {
  ArchiveReader archive(bytes);
  const BodyMemory memory = state_->read(&archive);
  if (archive.left() > 0)
    throw InputError("the saved body is followed by " + std::to_string(archive.left()) + " bytes");
  state_->recall(memory);
}

}  // namespace incision
