#include "report/tool/published.h"

#include <string>
#include <vector>

#include "report/tool/pressed.h"

namespace incision::report {
namespace {

using nlohmann::json;

// Of DiSECt's data: the knife's edge starts at this height above the table, 0.08 m less half the knife's height, and
// the data end at the other. Where they say nothing, a fit or a choice does.
constexpr double START = 0.06, STOP = 5e-3;   // [m]
constexpr double SPEED = 0.05;                // of most runs [m/s]
constexpr double POTATO = 0.048;              // sides of the prism [m]; chosen: those of the repository's grid
constexpr double POTATO_FORCE = 50 / POTATO;  // [N/m]; fitted to the plateau
constexpr double CUCUMBER = 0.037;            // diameter, and length [m]; fitted to the force at 0.6 s
constexpr double CUCUMBER_PLATEAU = 57.5;     // [N]; fitted: the force where the knife is half-way down
constexpr double LARGE = 0.05;                // diameter that the sphere's nodes suggest [m]
constexpr double KNIFE_STRIDE = 5e-4;         // [m]

// Of gelatin and elastomer: the block's sides are chosen, as are their E; of the forces only that by E counts.
const Vec3 BLOCK(0.04, 0.04, 0.03);           // [m]
constexpr double TRAVEL = 0.01414;            // [m]
constexpr double BLADE_STRIDE = 1e-4;         // [m]
constexpr double BLADE_SPEED = 1e-3;          // [m/s]
constexpr double COARSE = 5e-3, FINE = 4e-3;  // cells [m]

struct Soft {
  const char* name;
  double young_modulus;  // [Pa]
  double reached;        // (F_c + F_o)/E [m]; fitted to the middle of what was seen
  double steady;         // F_c/(F_c + F_o); chosen: gelatin gives way abruptly, the elastomer smoothly
  double before, after;  // depths at which the edge had not entered, and had [m]
};
const std::vector<Soft> SOFT = {{"gelatin", 1e4, 4.15e-3, 0.5, 4.19e-3, 6.18e-3},
                                {"elastomer", 1e5, 1.62e-3, 0.85, 1.56e-3, 2.29e-3}};

json traceOf(const Pressed& run) {
  const Felt felt = press(run);
  return {{"depth", felt.depth}, {"force", felt.force}, {"area", felt.area}};
}

json knife(Pressed run, double speed) {
  run.speed = speed;
  run.stride = KNIFE_STRIDE;
  run.travel = run.height - STOP;
  json trace = traceOf(run);
  trace["speed"] = speed;
  trace["met"] = (START - run.height) / speed;
  return trace;
}

Pressed potato(double cell) {
  Pressed run;
  run.mesh = prism(Vec3::Constant(POTATO), cell);
  run.height = POTATO;
  run.material = {2.0e6, 0.45, 630, 0, 0};
  run.force = POTATO_FORCE;
  run.beside = cell / 4;
  return run;
}

Pressed cucumber(double diameter, double cell) {
  Pressed run;
  run.mesh = cylinder(diameter, diameter, cell);
  run.height = diameter;
  run.held = 0.1 * diameter;
  run.material = {2.5e6, 0.37, 950, 0, 0};
  run.force = CUCUMBER_PLATEAU / diameter;
  run.beside = cell / 4;
  return run;
}

json soft(const Soft& material, double cell, double speed) {
  Pressed run;
  run.mesh = prism(BLOCK, cell);
  run.height = BLOCK.z();
  run.material = {material.young_modulus, 0.45, 1000, 0, 0};
  run.force = material.steady * material.reached * material.young_modulus;
  run.onset = (1 - material.steady) * material.reached * material.young_modulus;
  run.speed = speed;
  run.stride = BLADE_STRIDE;
  run.travel = TRAVEL;
  run.beside = cell / 4;
  json trace = traceOf(run);
  trace["cell"] = cell;
  trace["speed"] = speed;
  return trace;
}

json softs(const Soft& material, bool quick) {
  json found = {{"name", material.name},       {"young_modulus", material.young_modulus},
                {"reached", material.reached}, {"steady", material.steady},
                {"before", material.before},   {"after", material.after}};
  found["fitted"] = soft(material, COARSE, BLADE_SPEED);
  found["faster"] = soft(material, COARSE, 10 * BLADE_SPEED);
  found["finer"] = soft(material, FINE, BLADE_SPEED);
  found["finest"] = soft(material, quick ? 1e-2 / 3 : 2.5e-3, BLADE_SPEED);
  return found;
}

}  // namespace

json published(bool quick) {
  json found = {{"block", {BLOCK.x(), BLOCK.y(), BLOCK.z()}}, {"travel", TRAVEL}, {"cell", COARSE}};
  const double cell = quick ? 6e-3 : 4e-3;
  json& of_potato = found["potato"];
  of_potato = {{"side", POTATO}, {"force", POTATO_FORCE}};
  for (const double speed :
       quick ? std::vector<double>{SPEED, 0.035, 0.065} : std::vector<double>{SPEED, 0.035, 0.045, 0.055, 0.065})
    of_potato["runs"].push_back(knife(potato(cell), speed));
  json& of_cucumber = found["cucumber"];
  of_cucumber = {{"diameter", CUCUMBER}, {"force", CUCUMBER_PLATEAU / CUCUMBER}, {"large", LARGE}};
  for (const double speed : {SPEED, 0.035, 0.065})
    of_cucumber["runs"].push_back(knife(cucumber(CUCUMBER, cell), speed));
  of_cucumber["large_run"] = knife(cucumber(LARGE, cell), SPEED);
  for (const Soft& material : SOFT) found["soft"].push_back(softs(material, quick));
  return found;
}

}  // namespace incision::report
