// What memories of cracks must be.
#include "incision/fracture/cohesion.h"
#include "incision/fracture/growth.h"

namespace incision {
namespace {

template <typename Map>
void checkKeys(const Map& map, int count, const char* what) {
  for (const auto& [key, unused] : map) require(isOneOf(key, count), what);
}

void checkParts(const std::set<int>& parts, const MemoryLimits& limits) {
  for (const int part : parts) require(isOneOf(part, limits.parts()), "a crack cannot go through what is no part");
}

}  // namespace

void check(const CrackGrowth::Memory& memory, const MemoryLimits& limits) {
  checkKeys(memory.cracks.cracks, limits.cracks, "a crack that grows is none");
  for (const auto& [number, crack] : memory.cracks.cracks) {
    checkKeys(crack.phi, limits.copies, "a crack is known at what is no copy");
    checkKeys(crack.reached, limits.elements, "a crack has grown into what is no element");
    checkParts(crack.refused, limits);
  }
  for (const auto& [number, survivor] : memory.cracks.taken_in)
    require(isOneOf(number, limits.cracks) && memory.cracks.cracks.count(number) == 0 &&
                memory.cracks.cracks.count(survivor) > 0,
            "a crack is part of one that is none");
  require(isOneOf(memory.known_copies, limits.copies + 1), "its cracks know more copies than there are");
  checkParts(memory.barred, limits);
  require(memory.waiting.empty() || memory.waiting.size() == static_cast<std::size_t>(limits.nodes),
          "what waits are not its nodes");
  require(!memory.any_waiting || !memory.waiting.empty(), "what waits are not its nodes");
}

void check(const CohesionMemory& memory, const MemoryLimits& limits) {
  for (const Bond& bond : memory.bonds) {
    check(bond.section, limits);
    require(isOneOf(bond.region, limits.regions), "a bond is in no region");
    require(bond.area >= 0 && bond.steepest > 0 && bond.opened >= 0, "a bond has a size below 0");
  }
}

}  // namespace incision
