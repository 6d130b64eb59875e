#include "incision/scene/scene.h"

#include <cmath>
#include <limits>

#include "incision/base/input_error.h"
#include "incision/base/resolve_path.h"
#include "incision/base/yaml_reader.h"

namespace incision {

namespace {

// Softer or harder than this is a slip of units: rubber foam is 1e4 Pa, diamond 1e12 Pa.
constexpr Range YOUNG_MODULUS = {1e-3, 1e15};

// Beyond 0.4999 the material is incompressible for all that linear tetrahedra can show, and the bulk modulus, which
// grows as 1 / (1 − 2ν), spoils the solver's conditioning.
constexpr Range POISSON_RATIO = {0, 0.4999};

constexpr Range POSITIVE = {ABOVE_ZERO};
constexpr Range NOT_NEGATIVE = {0};

// A simulated time [s]: some thirty years, so that a time over the shortest step still counts exactly in a double.
constexpr Range TIME = {0, 1e9};

constexpr Range QUARTER_TURN = {0, 1.5707963267948966};  // [rad]
// Rubber on rubber has some 1.2; a material that clings has more. Above 10 nothing slides that would not stick.
constexpr Range FRICTION = {0, 10};

constexpr Range TIME_STEP = {1e-6, 1};
constexpr Range TOLERANCE = {1e-12, 1e-1};
constexpr int MAX_THREADS = 64;
constexpr std::size_t MAX_NAME = 255;   // bytes of a frame or link name, far above those in use
constexpr std::size_t MAX_PATH = 4096;  // bytes, as Linux has it

// How far from 1 the length of a quaternion may be before it is a mistake rather than rounding; tf2 has the same.
constexpr double QUATERNION_TOLERANCE = 1e-2;

// How many cells there may be in all is for the grid to say.
GridSettings parseGrid(const YamlValue& value) {
  const YamlMap map = value.map({"cells", "size", "origin"});
  GridSettings grid;
  const std::vector<YamlValue> cells = map.at("cells").list(3);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    grid.cells[axis] = cells[axis].integer(1, std::numeric_limits<int>::max());
  }
  if (map.has("size")) grid.size = map.at("size").vector(POSITIVE);
  grid.origin = map.vector("origin", grid.origin);
  return grid;
}

Material parseMaterial(const YamlValue& value) {
  const YamlMap map = value.map({"young_modulus", "poisson_ratio", "density", "mass_damping", "stiffness_damping"});
  Material material;
  material.young_modulus = map.number("young_modulus", material.young_modulus, YOUNG_MODULUS);
  material.poisson_ratio = map.number("poisson_ratio", material.poisson_ratio, POISSON_RATIO);
  material.density = map.number("density", material.density, POSITIVE);
  material.mass_damping = map.number("mass_damping", material.mass_damping, NOT_NEGATIVE);
  material.stiffness_damping = map.number("stiffness_damping", material.stiffness_damping, NOT_NEGATIVE);
  return material;
}

std::string parsePath(const YamlValue& value, const std::string& folder) {
  const std::string address = value.text(MAX_PATH);
  try {
    return resolvePath(address, folder);
  } catch (const InputError& error) {
    value.fail(error.what());
  }
}

std::string parseFrame(const YamlValue& value) {
  const std::string frame = value.text(MAX_NAME);
  if (frame.front() == '/') value.refuse("a tf2 frame, which does not begin with /");
  return frame;
}

BodySettings parseBody(const YamlValue& value, const std::string& folder) {
  const YamlMap map = value.map({"mesh", "grid", "frame", "material", "pressure", "warping", "mass"});
  if (map.has("mesh") == map.has("grid")) value.fail("needs a mesh or a grid (allowed: one of the two)");
  BodySettings body;
  if (const auto mesh = map.find("mesh")) body.mesh = parsePath(*mesh, folder);
  if (const auto grid = map.find("grid")) body.grid = parseGrid(*grid);
  if (const auto frame = map.find("frame")) body.frame = parseFrame(*frame);
  if (const auto material = map.find("material")) body.material = parseMaterial(*material);
  if (const auto pressure = map.find("pressure")) {
    body.pressure = pressure->choice<Pressure>({{"element", Pressure::ELEMENT}, {"averaged", Pressure::AVERAGED}});
  }
  if (const auto warping = map.find("warping")) body.warping = warping->boolean();
  if (const auto mass = map.find("mass")) {
    body.mass = mass->choice<Mass>({{"lumped", Mass::LUMPED}, {"consistent", Mass::CONSISTENT}});
  }
  return body;
}

Box parseBox(const YamlValue& value) {
  const std::vector<YamlValue> ends = value.list(2);
  const Box box = {ends[0].vector(), ends[1].vector()};
  if ((box.min.array() > box.max.array()).any()) {
    value.fail("a lower corner above the upper (allowed: [[x, y, z], [X, Y, Z]] with x <= X, y <= Y, z <= Z)");
  }
  return box;
}

Hold parseHold(const YamlValue& value) {
  const YamlMap map = value.map({"box", "velocity"});
  Hold hold;
  hold.box = parseBox(map.at("box"));
  hold.velocity = map.vector("velocity", hold.velocity);
  return hold;
}

Load parseLoad(const YamlValue& value) {
  const YamlMap map = value.map({"box", "traction", "ramp"});
  Load load;
  load.box = parseBox(map.at("box"));
  load.traction = map.at("traction").vector();
  load.ramp = map.number("ramp", load.ramp, TIME);
  return load;
}

SolverSettings parseSolver(const YamlValue& value) {
  const YamlMap map = value.map({"time_step", "method", "tolerance", "threads", "integrator"});
  SolverSettings solver;
  solver.time_step = map.number("time_step", solver.time_step, TIME_STEP);
  if (const auto method = map.find("method")) {
    solver.method =
        method->choice<Method>({{"auto", Method::AUTO}, {"direct", Method::DIRECT}, {"iterative", Method::ITERATIVE}});
  }
  solver.tolerance = map.number("tolerance", solver.tolerance, TOLERANCE);
  if (const auto threads = map.find("threads")) solver.threads = threads->integer(1, MAX_THREADS);
  if (const auto integrator = map.find("integrator"))
    solver.integrator = integrator->choice<Integrator>({{"euler", Integrator::EULER}, {"bdf2", Integrator::BDF2}});
  return solver;
}

ScheduledCut parseCut(const YamlValue& value) {
  const YamlMap map = value.map({"time", "label", "point", "normal", "tangent", "length", "width"});
  ScheduledCut cut;
  cut.time = map.number("time", cut.time, TIME);
  if (const auto label = map.find("label")) cut.plane.label = label->text(MAX_LABEL);
  cut.plane.point = map.vector("point", cut.plane.point);
  cut.plane.normal = map.at("normal").vector();
  cut.plane.tangent = map.vector("tangent", cut.plane.tangent);
  cut.plane.length = map.number("length", cut.plane.length, NOT_NEGATIVE);
  cut.plane.width = map.number("width", cut.plane.width, NOT_NEGATIVE);
  const std::string why = whyInvalid(cut.plane);
  if (!why.empty()) value.fail(why);
  return cut;
}

ContactSettings parseContact(const YamlValue& value, const std::string& folder) {
  const YamlMap map = value.map({"ground", "obstacles", "friction", "self"});
  ContactSettings contact;
  if (const auto ground = map.find("ground")) contact.ground = ground->number();
  if (const auto obstacles = map.find("obstacles")) contact.obstacles = parsePath(*obstacles, folder);
  contact.friction = map.number("friction", contact.friction, FRICTION);
  if (const auto self = map.find("self")) contact.self = self->boolean();
  return contact;
}

TimedPose parsePose(const YamlValue& value) {
  const std::vector<YamlValue> entries = value.list(8);
  const auto at = [&](int i) { return entries[static_cast<std::size_t>(i)].number(); };
  TimedPose timed;
  timed.time = entries[0].number(TIME);
  timed.pose.position = Vec3(at(1), at(2), at(3));
  timed.pose.orientation = Eigen::Quaterniond(at(7), at(4), at(5), at(6));
  const double length = timed.pose.orientation.norm();
  if (!(std::abs(length - 1) <= QUATERNION_TOLERANCE)) {
    value.fail("a quaternion of length " + std::to_string(length) +
               " (allowed: [t, x, y, z, qx, qy, qz, qw], length 1)");
  }
  timed.pose.orientation.normalize();
  return timed;
}

std::vector<TimedPose> parsePoses(const std::vector<YamlValue>& values) {
  std::vector<TimedPose> poses;
  for (const YamlValue& value : values) {
    const TimedPose timed = parsePose(value);
    if (!poses.empty() && timed.time <= poses.back().time) {
      value.fail("not later than the pose before it (allowed: ascending times)");
    }
    poses.push_back(timed);
  }
  return poses;
}

ToolSettings parseTool(const YamlValue& value, const std::string& folder) {
  const YamlMap map = value.map({"description", "link", "edge", "poses", "frame", "max_step", "timeout",
                                 "cutting_force", "friction", "progressive"});
  ToolSettings tool;
  if (!map.has("edge") && !map.has("description")) value.fail("needs an edge, or a description that has one");
  if (const auto description = map.find("description")) tool.description = parsePath(*description, folder);
  if (const auto edge = map.find("edge")) {
    const std::vector<YamlValue> ends = edge->list(2);
    tool.edge = {ends[0].vector(), ends[1].vector()};
    if ((*tool.edge)[0] == (*tool.edge)[1]) edge->fail("both ends are the same point (allowed: two points)");
    if (const auto link = map.find("link")) tool.link = link->text(MAX_NAME);
  } else {
    tool.link = map.at("link").text(MAX_NAME);
  }
  tool.poses = parsePoses(map.list("poses"));
  if (const auto frame = map.find("frame")) tool.frame = parseFrame(*frame);
  tool.max_step = map.numberOrInfinity("max_step", tool.max_step, POSITIVE);
  tool.timeout = map.numberOrInfinity("timeout", tool.timeout, POSITIVE);
  tool.cutting_force = map.number("cutting_force", tool.cutting_force, NOT_NEGATIVE);
  tool.friction = map.number("friction", tool.friction, FRICTION);
  if (const auto progressive = map.find("progressive")) tool.progressive = progressive->boolean();
  return tool;
}

FractureSettings parseFracture(const YamlValue& value) {
  const YamlMap map = value.map(
      {"tensile_strength", "compressive_strength", "crack_speed", "fuse_distance", "fuse_angle", "fracture_energy"});
  FractureSettings fracture;
  fracture.tensile_strength = map.numberOrInfinity("tensile_strength", fracture.tensile_strength, POSITIVE);
  fracture.compressive_strength = map.numberOrInfinity("compressive_strength", fracture.compressive_strength, POSITIVE);
  fracture.crack_speed = map.numberOrInfinity("crack_speed", fracture.crack_speed, POSITIVE);
  fracture.fuse_distance = map.number("fuse_distance", fracture.fuse_distance, NOT_NEGATIVE);
  fracture.fuse_angle = map.number("fuse_angle", fracture.fuse_angle, QUARTER_TURN);
  if (const auto energy = map.find("fracture_energy")) {
    if (std::isinf(fracture.tensile_strength)) energy->fail("needs a tensile_strength");
    fracture.fracture_energy = energy->number(POSITIVE);
  }
  if (std::isinf(fracture.tensile_strength) && std::isinf(fracture.compressive_strength)) {
    value.fail("needs a tensile_strength or a compressive_strength (allowed: above 0 Pa, one of them finite)");
  }
  return fracture;
}

Scene parseSections(const YamlValue& root, const std::string& folder) {
  const YamlMap map =
      root.map({"body", "gravity", "boundary", "loads", "solver", "cuts", "fracture", "contact", "tool"});
  Scene scene;
  scene.body = parseBody(map.at("body"), folder);
  scene.gravity = map.vector("gravity", scene.gravity);
  for (const YamlValue& hold : map.list("boundary")) scene.boundary.push_back(parseHold(hold));
  for (const YamlValue& load : map.list("loads")) scene.loads.push_back(parseLoad(load));
  if (const auto solver = map.find("solver")) scene.solver = parseSolver(*solver);
  for (const YamlValue& cut : map.list("cuts")) scene.cuts.push_back(parseCut(cut));
  if (const auto fracture = map.find("fracture")) scene.fracture = parseFracture(*fracture);
  if (const auto contact = map.find("contact")) scene.contact = parseContact(*contact, folder);
  if (const auto tool = map.find("tool")) scene.tool = parseTool(*tool, folder);
  return scene;
}

}  // namespace

Scene parseScene(const YAML::Node& root, const std::string& source, const std::string& folder) {
  try {
    return parseSections(YamlValue(root, source), folder);
  } catch (const YAML::Exception& error) {
    throw InputError(source + ": " + error.what());
  }
}

}  // namespace incision
