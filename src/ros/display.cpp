#include "incision/ros/display.h"

#include <algorithm>
#include <new>
#include <utility>

#include "incision/ros/surface_cloud.h"

namespace incision {
namespace {

/// What is to be seen of a force at least, per kg of the body [N/kg]: a thousandth of its weight.
constexpr double LEAST_FORCE = 0.01;

std::vector<std::string> namesOf(const std::vector<ToolSettings>& tools) {
  std::vector<std::string> names;
  for (const ToolSettings& tool : tools) names.push_back(tool.name);
  return names;
}

/// Of each triangle, the value of its part.
std::vector<double> ofTriangles(const Surface& surface, const std::vector<double>& of_parts) {
  std::vector<double> values;
  values.reserve(surface.part.size());
  for (int part : surface.part) values.push_back(of_parts[static_cast<std::size_t>(part)]);
  return values;
}

std::vector<ToolView> toolViews(const DeformableBody& body, const StepResult& last_step) {
  std::vector<ToolView> views;
  for (std::size_t i = 0; i < body.tools(); ++i) {
    const Vec3 force = i < last_step.tools.size() ? last_step.tools[i].force : Vec3::Zero();
    views.push_back({body.scene().tools[i].name, body.toolGroups(i), force});
  }
  return views;
}

}  // namespace

DisplayTopology::DisplayTopology(const DeformableBody& body) : surface(body.surface()), held(body.heldCopies()) {
  for (int part : surface.part)
    regions.push_back(body.materials().regions().of(body.mesh().parts()[static_cast<std::size_t>(part)].element));
  if (surface.triangles.size() > ROUNDED_UP_TO) return;
  std::vector<Vec3> copies;
  for (int c = 0; c < body.mesh().numCopies(); ++c)
    copies.push_back(body.mesh().mesh().nodes[static_cast<std::size_t>(body.mesh().copyNode(c))]);
  rest = surfacePositions(surface, copies);
}

DisplaySnapshot DisplaySource::take(const DeformableBody& body, const std::vector<Pose>& links,
                                    const StepResult& last_step, const DisplayWishes& wishes) {
  DisplaySnapshot snapshot;
  snapshot.wishes = wishes;
  if (wishes.markers || wishes.stress()) addBody(body, &snapshot);
  snapshot.step = body.steps();
  if (wishes.contacts) snapshot.wrenches = body.wrenches();
  if (wishes.obstacles) snapshot.links = links;
  if (wishes.tools) snapshot.tools = toolViews(body, last_step);
  return snapshot;
}

void DisplaySource::addBody(const DeformableBody& body, DisplaySnapshot* snapshot) {
  if (!topology_ || topology_version_ != body.topologyVersion()) {
    topology_ = std::make_shared<DisplayTopology>(body);
    topology_version_ = body.topologyVersion();  // which the body may have had to find its surface anew for
  }
  if (snapshot->wishes.stress() && !topology_->mesh) {
    topology_ = std::make_shared<DisplayTopology>(*topology_);  // another thread may be reading the other one
    topology_->mesh = std::make_shared<CutMesh>(body.mesh());
  }
  snapshot->topology = topology_;
  snapshot->positions = body.positions();
  if (snapshot->wishes.markers && !body.scene().loads.empty()) snapshot->loads = body.loadForces();
}

DisplayBuilder::DisplayBuilder(const DeformableBody& body)
    : body_settings_(body.scene().body),
      materials_(body.materials()),
      obstacles_(body.obstacles()),
      contact_names_(contactNames(obstacles_, namesOf(body.scene().tools))),
      body_size_((body.bounds().max - body.bounds().min).norm()),
      time_step_(body.scene().solver.time_step),
      force_scale_(body_size_, LEAST_FORCE * body.motion().mass) {
  for (std::size_t i = 0; i < body.tools(); ++i) tool_forms_.push_back(body.toolForm(i));
}

DisplayMessages DisplayBuilder::build(const DisplaySnapshot& snapshot, const ros::Time& stamp) {
  DisplayMessages messages;
  try {
    if (snapshot.topology) addBody(snapshot, stamp, &messages);
  } catch (const std::bad_alloc&) {
    stress_.reset();  // which may be half found
    throw;
  }
  if (snapshot.wrenches) messages.contacts = contactsOf(snapshot, stamp);
  if (snapshot.links) messages.obstacles = toMarkers(obstacles_, *snapshot.links, frame_, stamp);
  if (snapshot.tools) messages.tools = toolsOf(snapshot, stamp);
  return messages;
}

visualization_msgs::MarkerArray DisplayBuilder::toolsOf(const DisplaySnapshot& snapshot, const ros::Time& stamp) {
  double largest = 0;
  for (const ToolView& tool : *snapshot.tools) largest = std::max(largest, tool.force.norm());
  const ToolScale scale = {body_size_, force_scale_.at(static_cast<double>(snapshot.step) * time_step_, largest)};
  return toMarkers(tool_forms_, *snapshot.tools, scale, frame_, stamp);
}

Contacts DisplayBuilder::contactsOf(const DisplaySnapshot& snapshot, const ros::Time& stamp) const {
  Contacts contacts = toContacts(*snapshot.wrenches, contact_names_);
  contacts.header.stamp = stamp;
  contacts.header.frame_id = frame_;
  contacts.step = static_cast<std::uint64_t>(snapshot.step);
  return contacts;
}

/// Of each part.
std::vector<double> DisplayBuilder::findStress(const DisplaySnapshot& snapshot) {
  const DisplayTopology& topology = *snapshot.topology;
  if (!stress_ || &stress_->mesh() != topology.mesh.get())
    stress_ = std::make_unique<StressView>(topology.mesh, materials_, body_settings_, snapshot.positions);
  return stress_->vonMises(snapshot.positions);
}

/// Null where it is not rounded.
const Rounding* DisplayBuilder::roundingOf(const std::shared_ptr<DisplayTopology>& topology) {
  if (topology->rest.empty()) return nullptr;
  if (rounded_ != topology) rounding_ = std::make_unique<Rounding>(topology->surface, topology->rest);
  rounded_ = topology;
  return rounding_.get();
}

/// But for the rounding and what stress tells.
BodyView DisplayBuilder::viewOf(const DisplaySnapshot& snapshot) const {
  const DisplayTopology& topology = *snapshot.topology;
  BodyView view;
  view.surface = &topology.surface;
  view.x = surfacePositions(topology.surface, snapshot.positions);
  view.field = snapshot.wishes.field;
  view.num_regions = materials_.regions().count();
  view.regions = topology.regions;
  view.element_size = materials_.meanSize();
  for (int c : topology.held) view.held.push_back(snapshot.positions[static_cast<std::size_t>(c)]);
  for (std::size_t c = 0; c < snapshot.loads.size(); ++c)
    if (!snapshot.loads[c].isZero(0)) view.loads.emplace_back(snapshot.positions[c], snapshot.loads[c]);
  return view;
}

void DisplayBuilder::addBody(const DisplaySnapshot& snapshot, const ros::Time& stamp, DisplayMessages* messages) {
  const DisplayTopology& topology = *snapshot.topology;
  const DisplayWishes& wishes = snapshot.wishes;
  BodyView view = viewOf(snapshot);
  if (wishes.stress()) {
    const std::vector<double> of_parts = findStress(snapshot);
    if (wishes.region_stress) messages->region_stress = stress_->ofRegions(of_parts);
    view.von_mises = ofTriangles(topology.surface, of_parts);
  }
  if (wishes.cloud) messages->cloud = toCloud(topology.surface, view.x, view.regions, view.von_mises, frame_, stamp);
  if (!wishes.markers) return;
  view.rounding = roundingOf(snapshot.topology);
  messages->body = toMarkers(view, frame_, stamp);
}

}  // namespace incision
