#pragma once

namespace incision {

class YamlMap;

/// A probe has nothing beside what all tools have.
struct ProbeSettings {};

/// Its keys in a tool's entry. Throws InputError.
ProbeSettings parseProbe(const YamlMap& tool);

}  // namespace incision
