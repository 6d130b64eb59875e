#include "incision/rigid/description.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <map>
#include <set>

#include "incision/base/input_error.h"
#include "incision/base/lists.h"
#include "incision/base/printable.h"
#include "incision/base/suggestion.h"
#include "incision/base/yaml_reader.h"
#include "incision/rigid/box.h"
#include "incision/rigid/capsule.h"
#include "incision/rigid/cylinder.h"
#include "incision/rigid/sphere.h"
#include "limits.h"
#include "mesh_files.h"
#include "urdf_text.h"

namespace incision {

namespace {

// urdfdom's XML parser calls itself for every nested element, at under 400 bytes of stack each: this many fit twice
// into the usual 8 MB. A large humanoid has some 5,000.
constexpr std::ptrdiff_t MAX_ELEMENTS = 10'000;

// Bytes: what people write is a hundredth of it.
constexpr std::size_t MAX_DESCRIPTION = std::size_t{1} << 20;

// urdfdom's XML parser trusts the first byte of a character, which promises up to four, and reads past the end of a
// text that breaks off within one. These come after it.
constexpr const char* PADDING = "    ";

// Keeps urdfdom from printing and remembers its first complaint, for as long as it lives. urdfdom hands text of the
// description to printf as the format: where a '%' may be in it, written out or as a reference, it is not heard at all.
class QuietConsole : public console_bridge::OutputHandler {
 public:
  explicit QuietConsole(const std::string& urdf) : previous_(console_bridge::getOutputHandler()) {
    const bool may_be_heard = urdf.find_first_of("%&") == std::string::npos;
    console_bridge::useOutputHandler(may_be_heard ? this : nullptr);
  }
  ~QuietConsole() override { console_bridge::useOutputHandler(previous_); }
  QuietConsole(const QuietConsole&) = delete;
  QuietConsole& operator=(const QuietConsole&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (complaint_.empty() && level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) complaint_ = ": " + text;
  }
  /// ": reason", or nothing.
  const std::string& complaint() const { return complaint_; }

 private:
  console_bridge::OutputHandler* previous_;
  std::string complaint_;
};

std::string oneLine(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text;
}

void checkSize(const std::string& urdf, const std::string& name) {
  if (urdf.size() > MAX_DESCRIPTION) {
    throw InputError(name + ": the description is too large (allowed: up to " + std::to_string(MAX_DESCRIPTION) +
                     " bytes)");
  }
  std::ptrdiff_t elements = 0;
  for (std::size_t i = 0; i + 1 < urdf.size(); ++i) elements += urdf[i] == '<' && urdf[i + 1] != '/';
  if (elements > MAX_ELEMENTS) {
    throw InputError(name + ": " + std::to_string(elements) + " elements (allowed: up to " +
                     std::to_string(MAX_ELEMENTS) + ")");
  }
}

struct Parsed {
  urdf::ModelInterfaceSharedPtr model;
  std::string complaint;  // ": reason", or nothing
};

Parsed parseModel(const std::string& urdf, const std::string& name) {
  QuietConsole console(urdf);
  try {
    if (const auto model = urdf::parseURDF(urdf + PADDING)) return {model, oneLine(console.complaint())};
  } catch (const std::exception& error) {
    throw InputError(name + ": not a robot description: " + oneLine(error.what()));
  }
  throw InputError(name + ": not a robot description" + oneLine(console.complaint()));
}

Vec3 toVec3(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Pose toPose(const urdf::Pose& pose) {
  const urdf::Rotation& q = pose.rotation;
  return {toVec3(pose.position), Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized()};
}

/// What a collision's solid is read from, beside its geometry.
struct Source {
  MeshFiles& meshes;
  std::string where;        // the link
  bool is_capsule = false;  // what urdfdom has for a cylinder
};

/// How a kind of solid is read.
struct SolidKind {
  decltype(urdf::Geometry::type) type;
  SolidPtr (*read)(const urdf::Geometry& geometry, const Source& source);
};

const SolidKind SOLID_KINDS[] = {
    {urdf::Geometry::SPHERE,
     [](const urdf::Geometry& geometry, const Source&) -> SolidPtr {
       return std::make_shared<Sphere>(static_cast<const urdf::Sphere&>(geometry).radius);
     }},
    {urdf::Geometry::BOX,
     [](const urdf::Geometry& geometry, const Source&) -> SolidPtr {
       return std::make_shared<Box>(toVec3(static_cast<const urdf::Box&>(geometry).dim));
     }},
    {urdf::Geometry::CYLINDER,
     [](const urdf::Geometry& geometry, const Source& source) -> SolidPtr {
       const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
       if (source.is_capsule) return std::make_shared<Capsule>(cylinder.radius, cylinder.length);
       return std::make_shared<Cylinder>(cylinder.radius, cylinder.length);
     }},
    {urdf::Geometry::MESH,
     [](const urdf::Geometry& geometry, const Source& source) -> SolidPtr {
       const auto& mesh = static_cast<const urdf::Mesh&>(geometry);
       return source.meshes.at(mesh.filename, toVec3(mesh.scale), source.where);
     }},
};

DescribedSolid toSolid(const urdf::Collision& collision, const Source& source) {
  DescribedSolid described;
  described.pose = toPose(collision.origin);
  for (const SolidKind& kind : SOLID_KINDS)
    if (kind.type == collision.geometry->type) described.solid = kind.read(*collision.geometry, source);
  return described;
}

/// What all links are read from.
struct Sources {
  std::string name;
  MeshFiles meshes;
  std::set<CollisionPlace> capsules;
};

DescribedLink toLink(const urdf::Link& link, const Pose& pose, Sources* sources) {
  DescribedLink described;
  described.name = link.name;
  described.pose = pose;
  Source source{sources->meshes, linkInMessage(sources->name, link.name)};
  for (std::size_t i = 0; i < link.collision_array.size(); ++i) {
    const auto& collision = link.collision_array[i];
    source.is_capsule = sources->capsules.count({link.name, i}) > 0;
    if (collision && collision->geometry) described.solids.push_back(toSolid(*collision, source));
  }
  return described;
}

JointKind kindOf(const urdf::Joint& joint) {
  switch (joint.type) {
    case urdf::Joint::FIXED:
      return JointKind::FIXED;
    case urdf::Joint::REVOLUTE:
    case urdf::Joint::CONTINUOUS:
      return JointKind::REVOLUTE;
    case urdf::Joint::PRISMATIC:
      return JointKind::PRISMATIC;
    default:
      return JointKind::OTHER;
  }
}

DescribedJoint toJoint(const urdf::Joint& joint, int parent, int child) {
  DescribedJoint described;
  described.name = joint.name;
  described.kind = kindOf(joint);
  described.parent = parent;
  described.child = child;
  described.origin = toPose(joint.parent_to_joint_origin_transform);
  described.axis = toVec3(joint.axis);
  if (joint.mimic)
    described.mimic = DescribedJoint::Mimic{joint.mimic->joint_name, joint.mimic->multiplier, joint.mimic->offset};
  if (joint.limits && joint.limits->lower < joint.limits->upper && joint.type != urdf::Joint::CONTINUOUS)
    described.limits = {joint.limits->lower, joint.limits->upper};
  return described;
}

// The links, parents before their children, and the joints by which they hang.
Description describe(const urdf::ModelInterface& model, Sources* sources) {
  std::vector<urdf::LinkConstSharedPtr> order = {model.getRoot()};
  Description description{sources->name, {toLink(*order[0], Pose(), sources)}};
  for (std::size_t i = 0; i < order.size(); ++i) {
    const urdf::LinkConstSharedPtr parent = order[i];  // order grows
    for (const auto& child : parent->child_links) {
      description.joints.push_back(
          toJoint(*child->parent_joint, static_cast<int>(i), static_cast<int>(description.links.size())));
      const Pose pose = composed(description.links[i].pose, description.joints.back().origin);
      description.links.push_back(toLink(*child, pose, sources));
      order.push_back(child);
    }
  }
  return description;
}

/// The index of the one called `name` of those that have names; "what does not exist, …" where there is none.
/// `allowed` says which of them may be meant.
template <class Named, class Allowed>
int indexOf(const std::string& name, const std::vector<Named>& all, const std::string& what, const char* if_none,
            const Allowed& allowed) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
  if (found != all.end()) return static_cast<int>(found - all.begin());
  std::vector<std::string> names;
  for (const Named& one : all)
    if (allowed(one)) names.push_back(one.name);
  throw InputError(what + " does not exist" + suggestion(name, names) +
                   " (allowed: " + (names.empty() ? if_none : printable(joined(names))) + ")");
}

}  // namespace

const DescribedLink& Description::link(const std::string& link) const { return links[linkIndex(link)]; }

int Description::linkIndex(const std::string& link) const {
  return indexOf(link, links, linkInMessage(name, link), "none, it has no links", [](const auto&) { return true; });
}

int Description::jointIndex(const std::string& joint) const {
  const auto moves = [](const DescribedJoint& one) {
    return one.kind == JointKind::REVOLUTE || one.kind == JointKind::PRISMATIC;
  };
  return indexOf(joint, joints, jointInMessage(name, joint), "none, no joint of it moves", moves);
}

Description parseDescription(const std::string& urdf, const std::string& name) {
  checkSize(urdf, name);
  UrdfText text(urdf + PADDING);
  text.checkExpanded(name);
  text.checkTree(name);
  Sources sources{name, MeshFiles(name), text.takeCapsules()};
  const Parsed parsed = parseModel(sources.capsules.empty() ? urdf : text.print(), name);
  Description description = describe(*parsed.model, &sources);
  std::map<std::string, std::size_t> collisions = text.countCollisions();
  for (DescribedLink& link : description.links)
    if (link.solids.size() < collisions[link.name]) link.fault = "a collision shape cannot be read" + parsed.complaint;
  return description;
}

std::string linkInMessage(const std::string& name, const std::string& link) {
  return name + ": link '" + oneLine(link) + "'";
}

std::string jointInMessage(const std::string& name, const std::string& joint) {
  return name + ": joint '" + oneLine(joint) + "'";
}

void checkSolid(const DescribedSolid& described, const std::string& where) {
  described.solid->check(where);
  checkPose(described.pose, where + ": the collision");
}

void checkPose(const Pose& pose, const std::string& where) {
  for (const double x : pose.position) checkCoordinate(x, where + " stands at");
  if (!pose.orientation.coeffs().allFinite()) throw InputError(where + ": rpy (allowed: finite numbers)");
}

}  // namespace incision
