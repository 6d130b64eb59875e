#include "incision/run/scene_key.h"

#include <xxhash.h>

#include <cereal/types/variant.hpp>
#include <cmath>
#include <memory>
#include <ostream>
#include <streambuf>
#include <vector>

#include "incision/base/archive.h"

// Which values of a scene count. A field that is left out of these lists no longer compiles.
namespace incision {

template <class Archive>
void save(Archive& archive, const Place& place) {
  archive(place.box.min, place.box.max, place.group);
}

template <class Archive>
void save(Archive& archive, const Material& material) {
  const auto& [young_modulus, poisson_ratio, density, mass_damping, stiffness_damping] = material;
  archive(young_modulus, poisson_ratio, density, mass_damping, stiffness_damping);
}

template <class Archive>
void save(Archive& archive, const RegionSettings& region) {
  const auto& [place, young_modulus, poisson_ratio, density, tensile_strength, compressive_strength, fracture_energy,
               cutting_force, cutting_viscosity, cutting_onset] = region;
  archive(place, young_modulus, poisson_ratio, density, tensile_strength, compressive_strength, fracture_energy,
          cutting_force, cutting_viscosity, cutting_onset);
}

/// The mesh counts itself.
template <class Archive>
void save(Archive& archive, const BodySettings& body) {
  const auto& [meshes, grid, frame, material, regions, warping, mass, pressure] = body;
  archive(frame, material, regions, warping, mass, pressure);
}

template <class Archive>
void save(Archive& archive, const TimedPose& timed) {
  const auto& [time, pose] = timed;
  archive(time, pose);
}

template <class Archive>
void save(Archive& archive, const TimedAngle& timed) {
  const auto& [time, angle] = timed;
  archive(time, angle);
}

/// A file of poses has been read by now.
template <class Archive>
void save(Archive& archive, const Clamp& clamp) {
  const auto& [place, velocity, frame, poses, poses_file] = clamp;
  archive(place, velocity, frame, poses);
}

template <class Archive>
void save(Archive& archive, const Load& load) {
  const auto& [place, traction, ramp, pressure] = load;
  archive(place, traction, ramp, pressure);
}

/// Results do not depend on how many threads there are.
template <class Archive>
void save(Archive& archive, const SolverSettings& solver) {
  const auto& [time_step, method, tolerance, threads, integrator, tension, iterations] = solver;
  archive(time_step, method, tolerance, integrator, tension, iterations);
}

template <class Archive>
void save(Archive& archive, const ScheduledCut& cut) {
  const auto& [time, plane] = cut;
  const auto& [label, point, normal, tangent, length, width] = plane;
  archive(time, label, point, normal, tangent, length, width);
}

template <class Archive>
void save(Archive& archive, const FractureSettings& fracture) {
  const auto& [tensile_strength, compressive_strength, crack_speed, fuse_distance, fuse_angle, fracture_energy] =
      fracture;
  archive(tensile_strength, compressive_strength, crack_speed, fuse_distance, fuse_angle, fracture_energy);
}

/// Of a URDF the text counts.
template <class Archive>
void save(Archive& archive, const ContactSettings& contact) {
  const auto& [ground, obstacles, friction, self] = contact;
  archive(ground, friction, self);
}

template <class Archive>
void save(Archive& archive, const CuttingSettings& cutting) {
  const auto& [resistance, progressive] = cutting;
  const auto& [force, viscosity, onset] = resistance;
  archive(force, viscosity, onset, progressive);
}

template <class Archive>
void save(Archive& archive, const BladeSettings& blade) {
  const auto& [edge, cutting] = blade;
  archive(edge, cutting);
}

template <class Archive>
void save(Archive& archive, const ScissorsSettings& scissors) {
  const auto& [cutting] = scissors;
  archive(cutting);
}

template <class Archive>
void save(Archive& archive, const GrasperSettings& grasper) {
  const auto& [closed, grip] = grasper;
  archive(closed, grip);
}

template <class Archive>
void save(Archive& archive, const JawSettings& jaw) {
  const auto& [joint, angles, file] = jaw;
  archive(joint, angles);
}

template <class Archive>
void save(Archive& archive, const ToolSettings& tool) {
  const auto& [name, description, link, kind, poses, poses_file, frame, jaw, max_step, timeout, friction] = tool;
  archive(name, link, kind, poses, frame, jaw, max_step, timeout, friction);
}

template <class Archive>
void save(Archive& archive, const Scene& scene) {
  const auto& [body, gravity, boundary, loads, solver, cuts, fracture, contact, tools] = scene;
  archive(body, gravity, boundary, loads, solver, cuts, fracture, contact, tools);
}

template <class Archive>
void save(Archive& archive, const Descriptions& descriptions) {
  const auto& [tools, obstacles] = descriptions;
  archive(tools, obstacles);
}

template <class Archive>
void save(Archive& archive, const PhysicalGroup& group) {
  const auto& [name, tag, dimension, nodes, triangles, elements] = group;
  archive(name, tag, dimension, nodes, triangles, elements);
}

template <class Archive>
void save(Archive& archive, const TetMesh& mesh) {
  const auto& [nodes, elements, groups] = mesh;
  archive(nodes, elements, groups);
}

namespace {

/// Takes bytes, and keeps no more of them than their hash.
class HashBuffer : public std::streambuf {
 public:
  HashBuffer() : state_(XXH3_createState(), XXH3_freeState) {
    if (!state_) throw std::bad_alloc();
    XXH3_64bits_reset(state_.get());
  }
  std::uint64_t hash() const { return XXH3_64bits_digest(state_.get()); }

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    XXH3_64bits_update(state_.get(), bytes, static_cast<std::size_t>(count));
    return count;
  }
  int_type overflow(int_type byte) override {
    const char one = traits_type::to_char_type(byte);
    xsputn(&one, 1);
    return byte;
  }

 private:
  std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state_;
};

template <typename... Values>
std::uint64_t hashOf(const Values&... values) {
  HashBuffer buffer;
  std::ostream out(&buffer);
  ArchiveWriter archive(out);
  archive(values...);
  return buffer.hash();
}

/// What files of meshes make of shapes: how large each is, and how far away and where its surface is from the corners
/// of a cube within it and from those of one round it.
void addForms(const Obstacles& obstacles, std::vector<double>* forms) {
  for (const Obstacle& shape : obstacles.shapes) {
    const Solid& solid = *shape.solid;
    const double reach = std::isfinite(solid.reach()) ? solid.reach() : 1;
    forms->push_back(reach);
    for (int corner = 0; corner < 8; ++corner)
      for (const double share : {0.1, 0.3, 0.9}) {
        const Vec3 way(corner % 2 == 0 ? -1 : 1, corner / 2 % 2 == 0 ? -1 : 1, corner / 4 == 0 ? -1 : 1);
        const SolidDistance at = solid.distanceTo(share * reach * way);
        forms->insert(forms->end(), {at.distance, at.normal.x(), at.normal.y(), at.normal.z()});
      }
  }
}

std::vector<double> formsOf(const DeformableBody& body) {
  std::vector<double> forms;
  addForms(body.obstacles(), &forms);
  for (std::size_t i = 0; i < body.tools(); ++i) addForms(body.toolForm(i).shapes, &forms);
  return forms;
}

}  // namespace

SceneKey keyOf(const DeformableBody& body, const Descriptions& descriptions) {
  const TetMesh& mesh = body.mesh().mesh();
  return {hashOf(body.scene(), descriptions, formsOf(body)), hashOf(mesh), static_cast<std::int64_t>(mesh.nodes.size()),
          static_cast<std::int64_t>(mesh.elements.size())};
}

}  // namespace incision
