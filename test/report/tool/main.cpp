// Force on a blade and opening of its cut against its depth, with elements that are cut bit by bit or whole.
#include "report/section.h"
#include "report/tool/published.h"
#include "report/tool/push.h"

namespace incision::report {
namespace {

using nlohmann::json;

constexpr double CUTTING_FORCE = 20;  // [N/m]
constexpr double PULL = 100;          // [Pa]
constexpr double STEADY = 0.02;       // depth from which the force is looked at: a cell of the coarse mesh [m]
constexpr int COARSE = 5, FINE = 9;   // cells over the height

/// A mesh's traces with and without progressive opening.
json pushBoth(Push setting) {
  json found = {{"cells", setting.cells}};
  for (const bool progressive : {true, false}) {
    setting.progressive = progressive;
    const Trace trace = push(setting);
    found[progressive ? "with" : "without"] = {
        {"depth", trace.depth}, {"force", trace.force}, {"area", trace.area}, {"opening", trace.opening}};
  }
  return found;
}

/// Openings of blocks cut by rectangles of one cell, two, ... up to a depth.
json openingsAtRest(int cells, double depth) {
  json points = json::array();
  for (int k = 0; k * cellSize(cells) < depth + 1e-9; ++k)
    points.push_back({k * cellSize(cells), openingAtRest(cells, PULL, k * cellSize(cells))});
  return points;
}

void measure(bool quick, json* data) {
  Push setting;
  if (quick) setting.depth = 0.06, setting.stride = 1e-3;
  for (const int cells : {COARSE, FINE}) {
    Push forced = setting, pulled = setting;
    forced.cells = pulled.cells = cells;
    forced.cutting_force = CUTTING_FORCE;
    pulled.pull = PULL;
    (*data)["force"].push_back(pushBoth(forced));
    json opening = pushBoth(pulled);
    opening["rest"] = openingsAtRest(cells, setting.depth);
    (*data)["opening"].push_back(opening);
  }
  const int finest = quick ? 11 : 15;
  (*data)["reference"] = {{"cells", finest}, {"points", openingsAtRest(finest, setting.depth)}};
  (*data)["cutting_force"] = CUTTING_FORCE;
  (*data)["young_modulus"] = YOUNG_MODULUS;
  (*data)["block"] = {BLOCK.x(), BLOCK.y(), BLOCK.z()};
  (*data)["pull"] = PULL;
  (*data)["steady"] = STEADY;
  (*data)["stride"] = setting.stride;
  (*data)["published"] = published(quick);
}

}  // namespace
}  // namespace incision::report

int main(int argc, char** argv) { return incision::report::writeSection(argc, argv, incision::report::measure); }
