#include "incision/body/state_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "incision/base/parallel.h"

namespace incision {
namespace {

/// 64-bit FNV-1a.
class Hash {
 public:
  template <typename T>
  void add(const T* values, std::size_t count) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(values);
    for (std::size_t i = 0; i < count * sizeof(T); ++i) value_ = (value_ ^ bytes[i]) * 1099511628211ULL;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 14695981039346656037ULL;
};

/// Largest |x − X| over the material [m]. Displacements are linear in each part, so its corners have the largest.
double largestDisplacement(const CutMesh& mesh, const std::vector<Vec3>& x) {
  std::vector<double> squares(mesh.parts().size());
  parallelFor(static_cast<int>(squares.size()), mesh.threads(), [&](int p) {
    const Part& part = mesh.parts()[p];
    std::array<Vec3, 4> u;
    for (int I = 0; I < 4; ++I) u[I] = x[part.copies[I]] - mesh.mesh().nodes[mesh.mesh().elements[part.element][I]];
    double largest = 0;
    for (const Barycentric& b : mesh.polytope(p).corners)
      largest = std::max(largest, (b[0] * u[0] + b[1] * u[1] + b[2] * u[2] + b[3] * u[3]).squaredNorm());
    squares[p] = largest;
  });
  return squares.empty() ? 0 : std::sqrt(*std::max_element(squares.begin(), squares.end()));
}

}  // namespace

BodyMotion motionOf(const Assembly& assembly, const Motion& motion, const Vec3& gravity) {
  BodyMotion sums;
  std::vector<Vec3> Mv;
  assembly.multiplyMass(motion.v, &Mv);
  for (std::size_t c = 0; c < motion.x.size(); ++c) {
    sums.mass += assembly.masses()[c];
    sums.momentum += Mv[c];
    sums.kinetic_energy += 0.5 * motion.v[c].dot(Mv[c]);
    sums.potential_energy -= assembly.masses()[c] * gravity.dot(motion.x[c]);
  }
  sums.max_displacement = largestDisplacement(assembly.mesh(), motion.x);
  sums.elastic_energy = assembly.elasticEnergy(motion.x);
  return sums;
}

std::uint64_t hashOf(std::int64_t steps, const CutMesh& mesh, const Motion& motion) {
  Hash hash;
  hash.add(&steps, 1);
  for (const Part& part : mesh.parts()) hash.add(part.copies.data(), part.copies.size());
  for (const auto* values : {&motion.x, &motion.v})
    for (const Vec3& value : *values) hash.add(value.data(), 3);
  return hash.value();
}

StateView::StateView(std::shared_ptr<const CutMesh> mesh, const Materials& materials, const BodySettings& settings,
                     const std::vector<Vec3>& x)
    : mesh_(std::move(mesh)), assembly_(*mesh_, materials, settings.mass, settings.pressure, settings.warping, 1) {
  assembly_.topologyChanged(x);
}

BodyMotion StateView::motion(const Motion& motion, const Vec3& gravity) {
  assembly_.rotate(motion.x);  // from those of the state before
  return motionOf(assembly_, motion, gravity);
}

}  // namespace incision
