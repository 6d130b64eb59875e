#include "benchmark/bullet_body.h"

#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableLinearElasticityForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <btBulletCollisionCommon.h>

#include "benchmark/lumped_mass.h"
#include "incision/fem/boundary.h"

namespace incision::bench {
namespace {

btVector3 toBullet(const Vec3& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

/// Held nodes get mass 0, which pins them.
std::unique_ptr<btSoftBody> makeBody(const Scene& scene, const TetMesh& mesh, btSoftBodyWorldInfo* world) {
  const std::vector<double> masses = lumpedMasses(scene, mesh);
  const std::vector<int> held = heldNodes(mesh, scene.boundary);
  std::vector<btVector3> positions;
  std::vector<btScalar> bullet_masses;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    positions.push_back(toBullet(mesh.nodes[n]));
    bullet_masses.push_back(held[n] >= 0 ? 0 : static_cast<btScalar>(masses[n]));
  }
  auto body =
      std::make_unique<btSoftBody>(world, static_cast<int>(mesh.nodes.size()), positions.data(), bullet_masses.data());
  for (const auto& nodes : mesh.elements) body->appendTetra(nodes[0], nodes[1], nodes[2], nodes[3]);
  body->initializeDmInverse();
  body->m_tetraScratches.resize(body->m_tetras.size());
  body->m_tetraScratchesTn.resize(body->m_tetras.size());
  body->m_cfg.drag = 0;
  body->m_cfg.kDP = 0;
  body->setActivationState(DISABLE_DEACTIVATION);
  return body;
}

}  // namespace

struct BulletBody::World {
  World(const Scene& scene, const TetMesh& mesh)
      : time_step(static_cast<btScalar>(scene.solver.time_step)),
        dispatcher(&configuration),
        elasticity(static_cast<btScalar>(scene.body.material.mu()), static_cast<btScalar>(scene.body.material.lambda()),
                   0, 0),
        gravity(toBullet(scene.gravity)),
        world(&dispatcher, &broadphase, &constraints, &configuration, &solver),
        body(makeBody(scene, mesh, &world.getWorldInfo())) {
    constraints.setDeformableSolver(&solver);
    world.setGravity(toBullet(scene.gravity));
    world.setImplicit(true);
    world.setLineSearch(false);
    world.setUseProjection(true);  // without it the held body stays at rest
    world.addSoftBody(body.get());
    world.addForce(body.get(), &elasticity);
    world.addForce(body.get(), &gravity);
  }
  ~World() { world.removeSoftBody(body.get()); }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  btScalar time_step;
  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher;
  btDbvtBroadphase broadphase;
  btDeformableBodySolver solver;
  btDeformableMultiBodyConstraintSolver constraints;
  btDeformableLinearElasticityForce elasticity;
  btDeformableGravityForce gravity;
  btDeformableMultiBodyDynamicsWorld world;
  std::unique_ptr<btSoftBody> body;
};

BulletBody::BulletBody(const Scene& scene, const TetMesh& mesh) : world_(std::make_unique<World>(scene, mesh)) {}

BulletBody::~BulletBody() = default;

// No substeps: exactly one step of Δt.
void BulletBody::step() { world_->world.stepSimulation(world_->time_step, 0); }

std::vector<Vec3> BulletBody::nodePositions() const {
  std::vector<Vec3> positions;
  for (int n = 0; n < world_->body->m_nodes.size(); ++n) {
    const btVector3& x = world_->body->m_nodes[n].m_x;
    positions.emplace_back(x.x(), x.y(), x.z());
  }
  return positions;
}

}  // namespace incision::bench
