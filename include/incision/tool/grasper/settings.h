#pragma once

namespace incision {

class YamlMap;

/// What a grasper has beside what all tools have. Both go with the instrument and the tissue: nothing fits any of them.
struct GrasperSettings {
  double closed = 0;  ///< angle of the joint at which the jaws have closed on what is between them [rad]
  double grip = 0;    ///< largest force with which they hold it [N]
};

/// Its keys in a tool's entry. Throws InputError.
GrasperSettings parseGrasper(const YamlMap& tool);

}  // namespace incision
