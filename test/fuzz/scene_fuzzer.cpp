// Whatever a scene's text is, reading it gives a scene or an InputError.
#include <yaml-cpp/yaml.h>

#include <cstdint>
#include <string>

#include "incision/base/input_error.h"
#include "incision/scene/scene.h"

namespace {

// Loading hides these behind a file; the fuzzer has no time to write one.
YAML::Node yaml(const std::string& text) {
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception&) {
    return {};
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    incision::parseScene(yaml(text), "scene.yaml", "/");
  } catch (const incision::InputError&) {
  }
  return 0;
}
