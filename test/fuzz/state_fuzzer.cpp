// Whatever is written over the bytes of a saved body, restoring it is refused, with the body as it was, or gives a body
// that steps or says that it cannot. The input is a list of what to write where: 4 bytes of place, 4 of length (up to 8
// count), 8 to write.
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <string>

#include "incision/base/input_error.h"
#include "incision/body/deformable_body.h"

namespace {

using namespace incision;

/// A slab that breaks and is cut, while a blade goes through it and forceps hold it.
constexpr const char* SCENE = R"(
body:
  grid: {cells: [4, 2, 1], size: [0.04, 0.02, 0.003], origin: [0, -0.01, -0.0015]}
  material: {young_modulus: 3.0e4, poisson_ratio: 0.3, density: 1000, mass_damping: 10, stiffness_damping: 2.0e-3}
gravity: [3, 0, -9.81]
boundary: [{box: [[0.039999, -1, -1], [1, 1, 1]]}]
solver: {time_step: 0.005, method: iterative, integrator: bdf2, threads: 1}
cuts: [{time: 0.03, label: across, point: [0.03, 0, 0], normal: [1, 0.2, 0.3]}]
fracture: {tensile_strength: 250, fracture_energy: 0.05}
contact: {ground: -0.0016}
tools:
  scalpel: {type: blade, edge: [[0, 0, -0.004], [0, 0, 0.004]], cutting_force: 0.5,
            poses: [[0, 0.02, -0.015, 0, 0, 0, 0, 1], [0.2, 0.0201, 0.015, 0, 0, 0, 0, 1]]}
  forceps: {type: grasper, description: forceps.urdf, link: palm, joint: jaw, closed: 0.05, grip: 0.05,
            poses: [[0, -0.012, 0, 0, 0, 0, 0, 1]], jaw: [[0, 0.5], [0.02, 0.03]]}
)";

constexpr const char* FORCEPS =
    "<robot name='forceps'><link name='palm'/><link name='upper'><collision><origin xyz='0.01 0 0.0015'/><geometry>"
    "<box size='0.02 0.006 0.002'/></geometry></collision></link><link name='lower'><collision><origin xyz='0.01 0 "
    "-0.0015'/><geometry><box size='0.02 0.006 0.002'/></geometry></collision></link><joint name='jaw' "
    "type='revolute'><parent link='palm'/><child link='upper'/><axis xyz='0 -1 0'/><limit lower='-1' upper='1' "
    "effort='1' velocity='1'/></joint><joint name='lower_joint' type='revolute'><parent link='palm'/><child "
    "link='lower'/><axis xyz='0 -1 0'/><limit lower='-1' upper='1' effort='1' velocity='1'/><mimic joint='jaw' "
    "multiplier='-1'/></joint></robot>";

std::string bytesOf(const DeformableBody& body) {
  std::ostringstream bytes;
  body.save(bytes);
  return bytes.str();
}

struct Saved {
  Saved() : scene(parseScene(YAML::Load(SCENE), "scene", "/")), body(scene, loadMesh(scene), {{FORCEPS, ""}, ""}) {
    for (int k = 0; k < 12; ++k) body.step();
    bytes = bytesOf(body);
    if (body.counts().cracks < 2) std::abort();
  }

  Scene scene;
  DeformableBody body;
  std::string bytes;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static Saved saved;
  std::string bad = saved.bytes;
  for (; size >= 16; data += 16, size -= 16) {
    std::uint32_t place = 0, length = 0;
    std::memcpy(&place, data, 4);
    std::memcpy(&length, data + 4, 4);
    place %= bad.size();
    length = std::min<std::uint32_t>(length % 9, static_cast<std::uint32_t>(bad.size()) - place);
    std::memcpy(bad.data() + place, data + 8, length);
  }
  if (size > 0) bad.resize(bad.size() * data[0] / 255);
  try {
    saved.body.restore(bad);
    saved.body.step();
  } catch (const StepFailed&) {
  } catch (const InputError&) {
    if (bytesOf(saved.body) != saved.bytes) std::abort();
    return 0;
  }
  saved.body.restore(saved.bytes);
  return 0;
}
