#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <string>

#include "incision/mesh/mesh_io.h"
#include "support/blade.h"
#include "support/random.h"
#include "support/tool.h"

namespace incision::test {

/// A straight pass of a blade through a whole body: all that may differ from one to the next.
struct StraightPass {
  enum class Body { GRID, CYLINDER, ORGAN };
  enum class Held { BEHIND, ONE_SIDE, BOTH_SIDES };

  Body body = Body::GRID;
  Held held = Held::BEHIND;  ///< the end that the blade comes to last, or what lies farther off the plane
  bool contact = false;      ///< the blade has a body of its own
  bool damped = false;
  double time_step = 0.01, duration = 0.5;  ///< of the pass [s]
  double young_modulus = 1e5;               ///< [Pa]
  double thickness = 0;                     ///< of the blade, in elements; 0: it has none
  double chord = 1;                         ///< of the blade along its way, as a share of the body's length there
  bool edge_amid = false;                   ///< the edge runs amid the blade's front, or else on its side
  double friction = 0;
  double cutting_force = 0;      ///< as a share of E h
  double offset = 0;             ///< of the plane from the body's middle, as a share of its half width
  double slant = 0;              ///< of the edge from across the way [rad]
  Mat3 axes = Mat3::Identity();  ///< columns: the plane's normal, the way, and what is across both
  unsigned seed = 0;             ///< of the mesh

  static StraightPass draw(unsigned seed) {
    Random random(seed);
    StraightPass pass;
    pass.seed = seed;
    pass.body = static_cast<Body>(random.index(3));
    pass.held = static_cast<Held>(random.index(3));
    pass.contact = random.index(4) > 0;
    pass.damped = random.index(2) > 0;
    pass.time_step = std::exp(random.uniform(std::log(2e-3), std::log(2e-2)));
    pass.duration = random.uniform(0.3, 0.8);
    pass.young_modulus = std::exp(random.uniform(std::log(1e4), std::log(1e7)));
    pass.thickness = random.index(5) > 0 ? random.uniform(1e-3, 0.2) : 0;
    pass.chord = random.uniform(0.1, 1);
    pass.edge_amid = random.index(2) > 0;
    pass.friction = random.uniform(0, 0.5);
    // An end that is not held gives way to a cutting force by more than is asked of the cut.
    if (pass.held == Held::BOTH_SIDES && random.index(2) > 0) pass.cutting_force = random.uniform(0, 0.01);
    pass.offset = random.uniform(-0.4, 0.4);
    pass.slant = random.uniform(-0.6, 0.6);
    pass.axes = random.rotation();
    return pass;
  }

  /// The gmsh ones: a cylinder of radius and height 0.05 m in elements of 14 mm, and config/meshes/organ.geo in such of
  /// 16 mm.
  TetMesh mesh() const {
    if (body == Body::GRID) {
      Random random(seed);
      return jitteredGrid({{6, 5, 4}, Vec3(0.06, 0.05, 0.04), Vec3::Zero()}, 0.15, &random);
    }
    const std::string folder = INCISION_SOURCE_DIR "/test/tool/blade/";
    return readGmsh(folder + (body == Body::CYLINDER ? "cylinder.msh" : "organ.msh"));
  }
};

inline std::ostream& operator<<(std::ostream& out, const StraightPass& pass) {
  return out << "seed " << pass.seed << ", body " << static_cast<int>(pass.body) << ", held "
             << static_cast<int>(pass.held) << ", contact " << pass.contact << ", damped " << pass.damped << ", step "
             << pass.time_step << " s, duration " << pass.duration << " s, E " << pass.young_modulus
             << " Pa, thickness " << pass.thickness << ", chord " << pass.chord << ", edge amid " << pass.edge_amid
             << ", friction " << pass.friction << ", cutting force " << pass.cutting_force << ", slant " << pass.slant;
}

/// A pass that is made step by step, until the blade has left the body, or has parted it from what is not held.
class PassUnderWay {
 public:
  explicit PassUnderWay(const StraightPass& pass)
      : pass_(pass), mesh_(pass.mesh()), size_(Materials(mesh_, Material()).meanSize()), normal_(pass.axes.col(0)) {
    for (const Vec3& X : mesh_.nodes) extent_.extend(pass.axes.transpose() * X);
    plane_ = extent_.center()[0] + pass.offset * extent_.sizes()[0] / 2;
    body_ = std::make_unique<DeformableBody>(scene(), mesh_, Descriptions{{urdf()}, ""});
  }

  void run() {
    // What its speed brings to the end of its way, and as much again for tissue that is dragged along.
    for (int steps = static_cast<int>(2 * pass_.duration / pass_.time_step); steps > 0 && !over_; --steps) advance();
  }

  bool over() const { return over_; }
  double size() const { return size_; }  ///< of an element [m]
  double thickness() const { return pass_.thickness * size_; }
  const DeformableBody& body() const { return *body_; }

  /// How far a corner of a cut face was from the plane in the body as it was when it was cut, at most [m].
  double farthest() const { return farthest_; }

  /// How far a corner of a cut face is from the plane in the body at rest, at most [m].
  double farthestAtRest() const {
    double farthest = 0;
    for (const Vec3& X : cutCorners(body_->mesh())) farthest = std::max(farthest, std::abs(normal_.dot(X) - plane_));
    return farthest;
  }

  /// How far a point of the body was from where it is at rest while it hung together [m].
  double dragged() const { return dragged_; }

 private:
  Scene scene() const {
    Scene scene;
    const double damping = pass_.damped ? 1 : 0;
    scene.body.material = {pass_.young_modulus, 0.4, 1000, 6 * damping, 0.01 * damping};
    scene.gravity = Vec3::Zero();
    scene.solver = {pass_.time_step, Method::AUTO, 1e-6, 1};
    for (const Vec3& X : mesh_.nodes)
      if (isHeld(pass_.axes.transpose() * X))
        scene.boundary.push_back({{X - Vec3::Constant(1e-9), X + Vec3::Constant(1e-9)}, Vec3::Zero()});
    if (pass_.contact) {
      scene.contact = ContactSettings();
      scene.contact->friction = pass_.friction;
    }
    ToolSettings tool;
    tool.link = "blade";
    tool.description = "blade.urdf";
    const Vec3 along = reach() * Vec3(0, std::sin(pass_.slant), std::cos(pass_.slant));
    const Vec3 side = pass_.edge_amid ? Vec3(0, 0, 0) : Vec3(-thickness() / 2, 0, 0);
    bladeOf(&tool).edge = {side - along, side + along};
    tool.friction = pass_.friction;
    bladeOf(&tool).cutting.resistance.force = pass_.cutting_force * pass_.young_modulus * size_;
    tool.max_step = 1e3;
    // A slanted edge comes to the body with one end first; and the body may give way for some elements.
    const double room = extent_.sizes()[2] / 2 * std::abs(std::tan(pass_.slant)) + 0.5 * size_;
    const double speed = (extent_.sizes()[1] + 2 * room) / pass_.duration;
    const double from = extent_.min()[1] - room, to = extent_.max()[1] + room + 4 * size_;
    tool.poses = {{0, poseAlong(from)}, {(to - from) / speed, poseAlong(to)}};
    scene.tools = {tool};
    return scene;
  }

  /// `at` in the axes of the pass.
  bool isHeld(const Vec3& at) const {
    const Vec3 deep = 0.3 * extent_.sizes(), low = extent_.min(), high = extent_.max();
    if (pass_.held == StraightPass::Held::BEHIND) return at[1] > high[1] - deep[1];
    const bool below = at[0]<std::min(plane_ - 1.5 * size_, low[0] + deep[0]), above = at[0]> std::max(
        plane_ + 1.5 * size_, high[0] - deep[0]);
    return below || (above && pass_.held == StraightPass::Held::BOTH_SIDES);
  }

  double reach() const { return extent_.sizes()[1] + extent_.sizes()[2]; }

  Pose poseAlong(double way) const {
    return {pass_.axes * Vec3(plane_, way, extent_.center()[2]), Eigen::Quaterniond(pass_.axes)};
  }

  /// A box whose front lies along the edge; none without thickness.
  std::string urdf() const {
    if (pass_.thickness == 0) return "<robot name='tool'><link name='blade'/></robot>";
    const double chord = std::max(0.3 * size_, pass_.chord * extent_.sizes()[1]);
    char text[400];
    std::snprintf(text, sizeof text,
                  "<robot name='tool'><link name='blade'><collision><origin xyz='0 %.12g %.12g' rpy='%.12g 0 0'/>"
                  "<geometry><box size='%.12g %.12g %.12g'/></geometry></collision></link></robot>",
                  -chord / 2 * std::cos(pass_.slant), chord / 2 * std::sin(pass_.slant), -pass_.slant, thickness(),
                  chord, 2 * reach());
    return text;
  }

  void advance() {
    const std::size_t before = body_->mesh().parts().size();
    over_ = !body_->step().cuts.empty();
    // What is loose then goes with the blade or flies off, and may come on its edge again.
    if (pass_.held == StraightPass::Held::ONE_SIDE && body_->counts().pieces > 1) over_ = true;
    const CutMesh& mesh = body_->mesh();
    for (std::size_t p = before; p < mesh.parts().size(); ++p) {
      const Polytope& polytope = mesh.polytope(static_cast<int>(p));
      for (const Facet& facet : polytope.facets) {
        if (facet.crack < 0) continue;
        for (const Barycentric& b : cornersOf(polytope, facet))
          farthest_ = std::max(farthest_, std::abs(normal_.dot(at(mesh.parts()[p], b, body_->positions())) - plane_));
      }
    }
    if (!over_) dragged_ = std::max(dragged_, body_->motion().max_displacement);
  }

  StraightPass pass_;
  TetMesh mesh_;
  double size_;
  Vec3 normal_;
  Eigen::AlignedBox3d extent_;  // of the body in the axes of the pass
  double plane_ = 0;            // n·X on it [m]
  std::unique_ptr<DeformableBody> body_;
  bool over_ = false;
  double farthest_ = 0, dragged_ = 0;
};

}  // namespace incision::test
