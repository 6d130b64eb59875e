#include "incision/base/foreign_words.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace incision {
namespace {

/// A key that tells which section it is, or which sections.
const std::string SCENE = "boundary", BODY = "regions", BODY_OR_REGION = "material", MATERIAL = "poisson_ratio",
                  GRID = "cells", CLAMP = "velocity", LOAD = "traction", PLACE = "group", SOLVER = "time_step",
                  CUT = "normal", FRACTURE = "crack_speed", CONTACT = "self", TOOL = "max_step";

const std::string
    HELD = "boundary: [{box: [[-1, -1, -1], [0.001, 1, 1]]}]",
    HELD_GROUP = "boundary: [{group: rib}]", LED = "boundary: [{group: rib, frame: rib_link}]",
    BLADE = "tools: {scalpel: {type: blade, edge: [[0, 0, 0], [0, 0, 0.1]], cutting_force: 40}}",
    GRASPER =
        "tools: {forceps: {type: grasper, description: forceps.urdf, link: palm, joint: jaw, closed: 0.1, grip: 5}}",
    PROBE = "tools: {hook: {type: probe, description: hook.urdf, link: hook, frame: hook_link}}",
    MATERIAL_OF_BODY = "body: {material: {young_modulus: 1.0e4, poisson_ratio: 0.45, density: 1000}}",
    MATERIAL_OF_REGION = "body: {regions: [{group: tumour, material: {young_modulus: 5.0e4}}]}",
    DAMPING = "body: {material: {mass_damping: 1, stiffness_damping: 0.001}}",
    MESH = "body: {mesh: liver.msh, scale: 0.001}",
    MESHES = "body: {meshes: {liver: {file: liver.msh, pose: [0, 0, 0.1, 0, 0, 1.57]}}}",
    GRID_OF_BODY = "body: {grid: {cells: [16, 4, 4], size: [0.4, 0.1, 0.1], origin: [0, 0, 0]}}",
    PRESSURE = "loads: [{group: skin, pressure: 200}]",
    TRACTION = "loads: [{box: [[0.999, -1, -1], [2, 1, 1]], traction: [0, 0, -1000]}]",
    TIME_STEP = "solver: {time_step: 0.01}",
    SOLVING = "solver: {method: iterative, tolerance: 1.0e-6, threads: 2, integrator: euler}",
    TOUCHING = "contact: {ground: -0.1, obstacles: room.urdf, friction: 0.3, self: true}",
    PLANE = "cuts: [{time: 0.5, point: [0.5, 0, 0], normal: [1, 0, 0]}]",
    STRENGTH = "fracture: {tensile_strength: 1.0e5, fracture_energy: 20}";

const std::string YOUNG = "e young youngmodulus youngsmodulus elasticmodulus elasticity modulus stiffness",
                  POISSON = "nu poisson poissonratio poissonsratio", DENSITY = "density rho massdensity",
                  RAYLEIGH = "damping dampingcoefficient rayleigh rayleighmass rayleighstiffness alpha beta",
                  LAME = "lambda mu lame bulkmodulus shearmodulus",
                  FIXED =
                      "anchor anchors bc bcs boundaryconditions clamp clamps clamped constrained constraint "
                      "constraints dirichlet equality fix fixed fixedconstraint fixednodes fixedpoints "
                      "fixedvertices fixture fixtures held hold pin pinned pins support supports weld welds",
                  PLACED = "offset origin orientation pose position rotation transform translation";

/// As the words are written above.
std::string plain(const std::string& key) {
  std::string word;
  for (const unsigned char c : key)
    if (c != '_' && c != '-' && c != ' ') word += static_cast<char>(std::tolower(c));
  return word;
}

bool stands(const std::string& word, const std::string& words) {
  std::istringstream all(words);
  for (std::string each; all >> each;)
    if (each == word) return true;
  return false;
}

}  // namespace

const std::vector<ForeignWords>& foreignWords() {
  static const std::vector<ForeignWords> all = {
      {SCENE + " " + BODY,
       "attach attached attachment attachments",
       "an entry of boundary holds nodes, with a frame they follow it, and a tool that takes hold is a grasper:",
       {LED, GRASPER}},
      {SCENE + " " + BODY, FIXED, "nodes are held by", {HELD, HELD_GROUP}},
      {SCENE + " " + BODY,
       "externalforce externalforces force forces load neumann surfaceload traction tractions",
       "forces act on faces:",
       {PRESSURE, TRACTION}},
      {SCENE, "pressure pressures", "forces act on faces:", {PRESSURE, TRACTION}},
      {SCENE + " " + BODY, "tissue tissues", "tissues are regions of the body:", {MATERIAL_OF_REGION}},
      {SCENE, "region regions subset subsets", "regions are the body's:", {MATERIAL_OF_REGION}},
      {SCENE,
       "material materials " + YOUNG + " " + POISSON + " " + DENSITY + " " + LAME,
       "the material is the body's, and a region may have its own:",
       {MATERIAL_OF_BODY, MATERIAL_OF_REGION}},
      {SCENE, RAYLEIGH, "damping is that of the body:", {DAMPING}},
      {SCENE,
       "actor actors bodies deformable deformables flex flexcomp flexes geom geometry model models object objects "
       "soft softbodies softbody world worldbody",
       "there is one body, of one mesh, of several, or of a grid:",
       {MESH, MESHES, GRID_OF_BODY}},
      {SCENE,
       "file filename grid mesh meshes meshfile msh scale unit units",
       "a mesh, with its unit in metres, or a grid is the body's:",
       {MESH, GRID_OF_BODY}},
      {SCENE + " " + BODY, PLACED, "meshes are moved and turned (x, y, z, roll, pitch, yaw) by", {MESHES}},
      {SCENE, "dt h maxstepsize simulationstep step stepsize timestep", "the time step is", {TIME_STEP}},
      {SCENE,
       "integrator linearsolver method newton numthreads solvers threads tolerance",
       "how steps are solved is told by",
       {SOLVING}},
      {SCENE,
       "duration endtime numsteps simulationtime steps stoptime",
       "how long it runs is told to the program, as incision_batch SCENE.yaml --steps 1000, and the node runs until it "
       "is ended",
       {}},
      {SCENE,
       "cut cutplane cutplanes cutting incision incisions slice",
       "a plane that cuts at some time, or a blade that does:",
       {PLANE, BLADE}},
      {SCENE,
       "crack cracks damage strength tear tearing tensilestrength toughness yield yieldstress",
       "the body tears where a strength is given:",
       {STRENGTH}},
      {SCENE + " " + BODY,
       "collider colliders collision collisions contacts environment floor friction frictioncoefficient ground "
       "obstacle obstacles plane rigid rigidbodies rigidbody self selfcollision static table terrain",
       "what the body touches is told by",
       {TOUCHING}},
      {SCENE,
       "endeffector forceps grasp grasper grasping grip gripper grippers hand jaw jaws",
       "what takes hold of the body is a tool of the type grasper:",
       {GRASPER}},
      {SCENE,
       "blade cutter instrument instruments knife needle probe scalpel scissors tool",
       "there may be several tools, each with a name and a type (blade, grasper, probe, scissors):",
       {BLADE, PROBE}},
      {SCENE,
       "actuator actuators agent arm arms joint joints link links manipulator robot robots urdf",
       "a robot stays outside: what touches the body is a tool, whose poses come by messages or by its tf frame:",
       {PROBE}},
      {SCENE,
       "camera cameras gui light lights render viewer visual visuals",
       "a scene says nothing of how it is seen: rviz shows what the node publishes",
       {}},

      {BODY_OR_REGION,
       "materials " + YOUNG + " " + POISSON + " " + DENSITY + " " + LAME,
       "it is part of the material:",
       {MATERIAL_OF_BODY, MATERIAL_OF_REGION}},
      {BODY, RAYLEIGH, "damping is part of the material:", {DAMPING}},
      {BODY, "file filename meshfile msh path", "a mesh is", {MESH}},
      {BODY, "unit units", "the unit of a mesh in metres is its scale:", {MESH}},
      {BODY, "cells dimensions divisions resolution size", "a box of cells is a grid:", {GRID_OF_BODY}},
      {BODY, "gravity", "gravity is the scene's:", {"gravity: [0, 0, -9.81]"}},
      {GRID, "dimensions divisions elements n resolution subdivisions", "the number of cells is", {GRID_OF_BODY}},
      {GRID, "extent length lengths", "how long the grid is [m] is its size:", {GRID_OF_BODY}},
      {GRID, "corner min offset position", "the corner with the least coordinates is its origin:", {GRID_OF_BODY}},
      {MATERIAL, YOUNG, "the stiffness in Pa is young_modulus:", {MATERIAL_OF_BODY}},
      {MATERIAL, POISSON, "it is poisson_ratio:", {MATERIAL_OF_BODY}},
      {MATERIAL, "mass rho massdensity", "mass is told by the density in kg/m3:", {MATERIAL_OF_BODY}},
      {MATERIAL,
       LAME,
       "it is told by young_modulus = mu (3 lambda + 2 mu) / (lambda + mu) and poisson_ratio = lambda / (2 (lambda + "
       "mu)):",
       {MATERIAL_OF_BODY}},
      {MATERIAL, RAYLEIGH, "damping is that of the whole body:", {DAMPING}},
      {MATERIAL,
       "constitutive hyperelastic law model neohookean type",
       "there is one law, linear elasticity that turns with the material:",
       {MATERIAL_OF_BODY}},
      {MATERIAL, "strength tensilestrength yield yieldstress", "strengths are told by", {STRENGTH}},

      {PLACE,
       "elements faces id indices name nodes set surface tag vertices",
       "a place is a group of the mesh by name, or a box:",
       {HELD_GROUP, HELD}},
      {CLAMP, "body follow link parent target", "what moves with a tf frame has its name:", {LED}},
      {CLAMP,
       "displacement motion path pose position trajectory",
       "a prescribed motion is poses of time, position and quaternion, or a velocity:",
       {"boundary: [{group: rib, poses: [[0, 0, 0, 0, 0, 0, 0, 1], [1, 0, 0, 0.01, 0, 0, 0, 1]]}]",
        "boundary: [{group: rib, velocity: [0, 0, 0.01]}]"}},
      {CLAMP,
       "axes axis directions dofs x y z",
       "an entry holds its nodes in all three directions:",
       {HELD, HELD_GROUP}},
      {LOAD,
       "direction force forces magnitude value vector",
       "a load is a pressure, or a traction, both in Pa: the force over the area:",
       {PRESSURE, TRACTION}},
      {SOLVER, "dt h maxstepsize step stepsize timestep", "the time step in s is", {TIME_STEP}},
      {SOLVER,
       "abstol cores epsilon linearsolver name nthreads numthreads reltol rtol scheme solver tol type",
       "how steps are solved is told by",
       {SOLVING}},
      {SOLVER,
       "maxiter maxiterations newtoniterations",
       "a step ends by its tolerance, and where that is asked for after so many iterations:",
       {SOLVING, "solver: {iterations: 20}"}},
      {SOLVER, "gravity", "gravity is the scene's:", {"gravity: [0, 0, -9.81]"}},
      {SOLVER, RAYLEIGH, "damping is that of the body:", {DAMPING}},
      {CUT, "at when", "the simulated time in s at which it cuts is", {PLANE}},
      {CUT, "center centre origin position", "a point of the plane is", {PLANE}},
      {CUT, "end from start to", "what is cut from one point to another is cut by a blade that is led:", {BLADE}},
      {CUT, "id name", "its name is", {"cuts: [{label: first, time: 0.5, point: [0.5, 0, 0], normal: [1, 0, 0]}]"}},
      {FRACTURE, "sigma strength threshold yield yieldstress", "the strength in Pa is", {STRENGTH}},
      {FRACTURE, "energy g gc toughness", "the energy in J/m2 is", {STRENGTH}},
      {CONTACT, "coefficient frictioncoefficient mu", "friction has one coefficient:", {TOUCHING}},
      {CONTACT, "floor plane table", "the height of the ground along z in m is", {TOUCHING}},
      {CONTACT, "collider colliders file mesh meshes model obstacle urdf", "obstacles are a URDF file:", {TOUCHING}},
      {CONTACT, "selfcollision selfcollisions selfcontact", "whether the body touches itself is", {TOUCHING}},
      {CONTACT,
       "alarmdistance contactdistance contactstiffness damping distance margin penalty restitution stiffness thickness",
       "how stiffly it touches follows from the body's material, so there is nothing more to tell than",
       {TOUCHING}},
      {TOOL, "file mesh model urdf", "a tool's shape is a link of a URDF file, its description:", {PROBE}},
      {TOOL, "kind", "blade, grasper, probe and scissors are its type:", {BLADE, GRASPER}},
      {TOOL,
       "path pose position topic trajectory",
       "a tool follows messages on its topic servo_cp, a tf frame, or poses of time, position and quaternion:",
       {PROBE,
        "tools: {scalpel: {type: blade, edge: [[0, 0, 0], [0, 0, 0.1]], poses: [[0, 0, 0, 0, 0, 0, 0, 1], [1, 0, 0.1, "
        "0, 0, 0, 0, 1]]}}"}},
      {TOOL, "inertia mass", "a tool is led and has no mass:", {PROBE}},
      {TOOL, "resistance sharpness toughness", "what cutting takes is the tissue's cutting_force in N/m:", {BLADE}},
      {TOOL, "finger fingers gripper opening", "jaws are a joint of the URDF file:", {GRASPER}},
  };
  return all;
}

std::string saidHere(const std::string& key, const std::vector<std::string>& allowed_keys) {
  const std::string word = plain(key);
  for (const ForeignWords& known : foreignWords()) {
    const auto is_here = [&](const std::string& allowed) { return stands(allowed, known.beside); };
    if (!stands(word, known.words) || std::none_of(allowed_keys.begin(), allowed_keys.end(), is_here)) continue;
    std::string said = ": " + known.how;
    for (std::size_t i = 0; i < known.examples.size(); ++i) said += (i == 0 ? " `" : " or `") + known.examples[i] + "`";
    return said;
  }
  return "";
}

}  // namespace incision
