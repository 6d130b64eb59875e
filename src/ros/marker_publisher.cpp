#include "incision/ros/marker_publisher.h"

#include <algorithm>
#include <cmath>

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

}  // namespace

MarkerPublisher::Topology::Topology(const DeformableBody& body) : surface(body.surface()), held(body.heldCopies()) {
  for (int part : surface.part)
    regions.push_back(body.materials().regions().of(body.mesh().parts()[static_cast<std::size_t>(part)].element));
  if (surface.triangles.size() > ROUNDED_UP_TO) return;
  std::vector<Vec3> copies;
  for (int c = 0; c < body.mesh().numCopies(); ++c)
    copies.push_back(body.mesh().mesh().nodes[static_cast<std::size_t>(body.mesh().copyNode(c))]);
  rest = surfacePositions(surface, copies);
}

MarkerPublisher::MarkerPublisher(ros::NodeHandle& node, const NodeSettings& settings, const DeformableBody& body)
    : body_settings_(settings.scene.body),
      materials_(body.materials()),
      obstacles_(body.obstacles()),
      contact_names_(contactNames(obstacles_, namesOf(settings.scene.tools))),
      body_size_((body.bounds().max - body.bounds().min).norm()),
      time_step_(settings.scene.solver.time_step),
      node_(node),
      force_scale_(body_size_, LEAST_FORCE * body.motion().mass) {
  for (std::size_t i = 0; i < body.tools(); ++i) tool_forms_.push_back(body.toolForm(i));
  set(settings.markers);
}

void MarkerPublisher::set(const MarkerSettings& settings) {
  field_ = settings.field;
  next_ = settings.rate > 0 ? std::chrono::steady_clock::now() : SteadyTime::max();
  if (settings.rate == 0) return;
  period_ = std::chrono::nanoseconds(std::llround(1e9 / settings.rate));
  if (!thread_.joinable()) start();
}

void MarkerPublisher::start() {
  const auto advertise = [&](const std::string& topic) {
    return node_.advertise<visualization_msgs::MarkerArray>(topic, 1);
  };
  body_publisher_ = advertise("markers");
  cloud_publisher_ = node_.advertise<sensor_msgs::PointCloud2>("surface", 1);
  contact_publisher_ = node_.advertise<Contacts>("contacts", 1);
  if (!obstacles_.shapes.empty()) obstacle_publisher_ = advertise("obstacles");
  if (!tool_forms_.empty()) tool_publisher_ = advertise("tool_markers");
  thread_ = std::thread([this] { run(); });
}

MarkerPublisher::~MarkerPublisher() {
  stopping_ = true;
  wakeup_.notify();
  if (thread_.joinable()) thread_.join();
}

void MarkerPublisher::offer(const DeformableBody& body, const std::vector<Pose>& links, const StepResult& last_step,
                            bool wants_stress, SteadyTime now) {
  if (now < next_) return;
  next_ = std::max(next_ + period_, now);
  Snapshot snapshot;
  snapshot.wants_markers = body_publisher_.getNumSubscribers() > 0;
  snapshot.wants_cloud = cloud_publisher_.getNumSubscribers() > 0;
  snapshot.wants_stress = wants_stress;
  snapshot.field = field_;
  if (snapshot.wants_markers || snapshot.wants_cloud || wants_stress) addBody(body, &snapshot);
  snapshot.step = body.steps();
  if (wantsContacts()) snapshot.wrenches = body.wrenches();
  if (obstacle_publisher_.getNumSubscribers() > 0) snapshot.links = links;
  if (tool_publisher_.getNumSubscribers() > 0) snapshot.tools = toolViews(body, last_step);
  if (snapshot.empty()) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    latest_ = std::move(snapshot);
  }
  wakeup_.notify();
}

void MarkerPublisher::addBody(const DeformableBody& body, Snapshot* snapshot) {
  if (!topology_ || topology_version_ != body.topologyVersion()) {
    topology_ = std::make_shared<Topology>(body);
    topology_version_ = body.topologyVersion();  // which the body may have had to find its surface anew for
  }
  if (snapshot->needsStress() && !topology_->mesh) {
    topology_ = std::make_shared<Topology>(*topology_);  // the thread may be reading the other one
    topology_->mesh = std::make_shared<CutMesh>(body.mesh());
  }
  snapshot->topology = topology_;
  snapshot->positions = body.positions();
  if (snapshot->wants_markers && !body.scene().loads.empty()) snapshot->loads = body.loadForces();
}

std::vector<ToolView> MarkerPublisher::toolViews(const DeformableBody& body, const StepResult& last_step) const {
  std::vector<ToolView> views;
  for (std::size_t i = 0; i < body.tools(); ++i) {
    const Vec3 force = i < last_step.tools.size() ? last_step.tools[i].force : Vec3::Zero();
    views.push_back({contact_names_.tools[i], body.toolGroups(i), force});
  }
  return views;
}

std::vector<RegionStress> MarkerPublisher::regionStress() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return region_stress_;
}

std::optional<MarkerPublisher::Snapshot> MarkerPublisher::take() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(latest_, std::nullopt);
}

void MarkerPublisher::publish(const Snapshot& snapshot) {
  const ros::Time stamp = ros::Time::now();
  if (snapshot.topology) publishBody(snapshot, stamp);
  if (snapshot.wrenches) publishContacts(snapshot, stamp);
  if (snapshot.links) obstacle_publisher_.publish(toMarkers(obstacles_, *snapshot.links, frame_, stamp));
  if (snapshot.tools) publishTools(snapshot, stamp);
}

void MarkerPublisher::publishTools(const Snapshot& snapshot, const ros::Time& stamp) {
  double largest = 0;
  for (const ToolView& tool : *snapshot.tools) largest = std::max(largest, tool.force.norm());
  const ToolScale scale = {body_size_, force_scale_.at(static_cast<double>(snapshot.step) * time_step_, largest)};
  tool_publisher_.publish(toMarkers(tool_forms_, *snapshot.tools, scale, frame_, stamp));
}

void MarkerPublisher::publishContacts(const Snapshot& snapshot, const ros::Time& stamp) {
  Contacts contacts = toContacts(*snapshot.wrenches, contact_names_);
  contacts.header.stamp = stamp;
  contacts.header.frame_id = frame_;
  contacts.step = static_cast<std::uint64_t>(snapshot.step);
  contact_publisher_.publish(contacts);
}

/// Of each triangle of the surface, and on the way that of the regions.
std::vector<double> MarkerPublisher::findStress(const Snapshot& snapshot) {
  const Topology& topology = *snapshot.topology;
  if (!stress_ || &stress_->mesh() != topology.mesh.get())
    stress_ = std::make_unique<StressView>(topology.mesh, materials_, body_settings_, snapshot.positions);
  const std::vector<double> of_parts = stress_->vonMises(snapshot.positions);
  if (snapshot.wants_stress) {
    std::vector<RegionStress> found = stress_->ofRegions(of_parts);
    const std::lock_guard<std::mutex> lock(mutex_);
    region_stress_ = std::move(found);
  }
  return ofTriangles(topology.surface, of_parts);
}

/// Null where it is not rounded.
const Rounding* MarkerPublisher::roundingOf(const std::shared_ptr<Topology>& topology) {
  if (topology->rest.empty()) return nullptr;
  if (rounded_ != topology) rounding_ = std::make_unique<Rounding>(topology->surface, topology->rest);
  rounded_ = topology;
  return rounding_.get();
}

void MarkerPublisher::publishBody(const Snapshot& snapshot, const ros::Time& stamp) {
  const Topology& topology = *snapshot.topology;
  std::vector<double> of_triangles;
  if (snapshot.needsStress()) of_triangles = findStress(snapshot);
  const std::vector<Vec3> x = surfacePositions(topology.surface, snapshot.positions);
  if (snapshot.wants_cloud)
    cloud_publisher_.publish(toCloud(topology.surface, x, topology.regions, of_triangles, frame_, stamp));
  if (!snapshot.wants_markers) return;
  BodyView view;
  view.surface = &topology.surface;
  view.x = x;
  view.rounding = roundingOf(snapshot.topology);
  view.field = snapshot.field;
  view.num_regions = materials_.regions().count();
  view.regions = topology.regions;
  view.von_mises = of_triangles;
  view.element_size = materials_.meanSize();
  for (int c : topology.held) view.held.push_back(snapshot.positions[static_cast<std::size_t>(c)]);
  for (std::size_t c = 0; c < snapshot.loads.size(); ++c)
    if (!snapshot.loads[c].isZero(0)) view.loads.emplace_back(snapshot.positions[c], snapshot.loads[c]);
  body_publisher_.publish(toMarkers(view, frame_, stamp));
}

void MarkerPublisher::run() {
  while (!stopping_) {
    try {
      if (const auto snapshot = take()) publish(*snapshot);
    } catch (const std::bad_alloc&) {  // the next one may find memory
      stress_.reset();
    }
    wakeup_.waitUntil(SteadyTime::max());
  }
}

}  // namespace incision
