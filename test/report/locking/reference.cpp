#include "report/locking/reference.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "report/temporary_folder.h"

namespace incision::report {
namespace {

using Index = std::array<int, 3>;

constexpr double GRADING = 10;

/// Places of the nodes of a C3D20R in a cell, in half cells, in the order of CalculiX.
constexpr std::array<Index, 20> PLACES = {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2},
                                           {0, 2, 2}, {1, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 1, 0}, {1, 0, 2}, {2, 1, 2},
                                           {1, 2, 2}, {0, 1, 2}, {0, 0, 1}, {2, 0, 1}, {2, 2, 1}, {0, 2, 1}}};

/// The box cut at its planes of symmetry, in bricks.
class Bricks {
 public:
  Bricks(const Problem& problem, int along_longest) : problem_(problem), origin_(problem.origin) {
    for (int a = 0; a < 3; ++a) {
      length_[a] = problem.symmetric[a] ? problem.size[a] / 2 : problem.size[a];
      if (problem.symmetric[a]) origin_[a] = 0;
      cells_[a] =
          std::max(4, 2 * static_cast<int>(std::lround(along_longest * length_[a] / problem.size.maxCoeff() / 2)));
    }
    for (int i = 0; i < cells_[0]; ++i)
      for (int j = 0; j < cells_[1]; ++j)
        for (int k = 0; k < cells_[2]; ++k) addCell({i, j, k});
    findLoads();
  }

  void write(std::ostream& out, double poisson_ratio) const;
  /// How often the part that is modelled fits into the box.
  double copies() const {
    return std::pow(2.0, std::count(problem_.symmetric.begin(), problem_.symmetric.end(), true));
  }
  const std::map<int, double>& loads() const { return loads_; }

 private:
  Vec3 position(const Index& place) const {
    return {coordinate(0, place[0]), coordinate(1, place[1]), coordinate(2, place[2])};
  }
  double coordinate(int axis, int place) const;
  void addCell(const Index& cell) {
    for (const Index& at : PLACES) {
      Index place;
      for (int a = 0; a < 3; ++a) place[a] = 2 * cell[a] + at[a];
      elements_.push_back(node_of_.try_emplace(place, static_cast<int>(node_of_.size()) + 1).first->second);
    }
  }
  void findLoads();
  void writeHolds(std::ostream& out) const;

  const Problem& problem_;
  Vec3 origin_, length_;
  Index cells_;
  std::map<Index, int> node_of_;
  std::vector<int> elements_;    // twenty nodes each
  std::map<int, double> loads_;  // area that belongs to each loaded node [m²]
};

/// Cells are GRADING times smaller at both ends of an axis than they would be all alike: stress is singular where held
/// sides end.
double Bricks::coordinate(int axis, int place) const {
  if (place % 2 == 1) return (coordinate(axis, place - 1) + coordinate(axis, place + 1)) / 2;
  const double s = 0.5 * place / cells_[axis], waves = 2 * M_PI * (problem_.symmetric[axis] ? 2 : 1);
  return origin_[axis] + length_[axis] * (s - (1 - 1 / GRADING) * std::sin(waves * s) / waves);
}

/// ∫ N dA of a loaded side: −1/12 of its area at a corner, 1/3 at the middle of an edge.
void Bricks::findLoads() {
  if (problem_.plate()) return;
  const int a = problem_.axis, b = (a + 1) % 3, c = (a + 2) % 3;
  for (int i = 0; i < cells_[b]; ++i)
    for (int j = 0; j < cells_[c]; ++j) {
      Index middle;
      middle[a] = 2 * cells_[a];
      middle[b] = 2 * i + 1;
      middle[c] = 2 * j + 1;
      if (!problem_.loads[0].box.contains(position(middle))) continue;
      const double area =
          (coordinate(b, 2 * i + 2) - coordinate(b, 2 * i)) * (coordinate(c, 2 * j + 2) - coordinate(c, 2 * j));
      for (int s = -1; s <= 1; ++s)
        for (int t = -1; t <= 1; ++t) {
          Index place = middle;
          place[b] += s;
          place[c] += t;
          if (s != 0 || t != 0) loads_[node_of_.at(place)] += s != 0 && t != 0 ? -area / 12 : area / 3;
        }
    }
}

void Bricks::writeHolds(std::ostream& out) const {
  out << "*BOUNDARY\n";
  for (const auto& [place, node] : node_of_) {
    const Vec3 X = position(place);
    const auto hold =
        std::find_if(problem_.holds.begin(), problem_.holds.end(), [&](const Hold& h) { return h.box.contains(X); });
    for (int a = 0; a < 3; ++a)
      if (hold != problem_.holds.end())
        out << node << ',' << a + 1 << ',' << a + 1 << ',' << hold->velocity[a] << '\n';
      else if (problem_.symmetric[a] && place[a] == 0)
        out << node << ',' << a + 1 << ',' << a + 1 << ",0\n";
  }
}

void Bricks::write(std::ostream& out, double poisson_ratio) const {
  out.precision(12);
  out << "*NODE, NSET=ALL\n";
  for (const auto& [place, node] : node_of_) {
    const Vec3 X = position(place);
    out << node << ',' << X.x() << ',' << X.y() << ',' << X.z() << '\n';
  }
  out << "*ELEMENT, TYPE=C3D20R, ELSET=BODY";
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    if (k % 20 == 0) out << '\n' << k / 20 + 1;
    out << (k % 20 == 10 ? ",\n" : ",") << elements_[k];
  }
  out << "\n*NSET, NSET=SIDE\n";
  for (const auto& [place, node] : node_of_)
    if (place[problem_.axis] == 2 * cells_[problem_.axis]) out << node << '\n';
  out << "*MATERIAL, NAME=TISSUE\n*ELASTIC\n" << YOUNG_MODULUS << ',' << poisson_ratio << '\n';
  out << "*SOLID SECTION, ELSET=BODY, MATERIAL=TISSUE\n*STEP\n*STATIC\n";
  writeHolds(out);
  if (!problem_.plate()) out << "*CLOAD\n";
  for (const auto& [node, area] : loads_)
    for (int a = 0; a < 3; ++a)
      if (problem_.loads[0].traction[a] != 0)
        out << node << ',' << a + 1 << ',' << area * problem_.loads[0].traction[a] << '\n';
  out << "*NODE PRINT, NSET=SIDE\n" << (problem_.plate() ? "RF" : "U") << "\n*END STEP\n";
}

/// What CalculiX printed of the nodes of the side: displacement or force.
std::map<int, Vec3> readNodes(const std::string& path) {
  std::ifstream file(path);
  std::map<int, Vec3> values;
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    int node;
    Vec3 v;
    if (words >> node >> v[0] >> v[1] >> v[2]) values[node] = v;
  }
  if (values.empty()) throw std::runtime_error("ccx has left no result");
  return values;
}

}  // namespace

double reference(const Problem& problem, double poisson_ratio, int cells) {
  const Bricks bricks(problem, cells);
  const TemporaryFolder folder;
  std::ofstream input(folder.file("box.inp"));
  bricks.write(input, poisson_ratio);
  input.close();
  folder.run("cd " + folder.file("") + " && ccx -i box");
  const std::map<int, Vec3> values = readNodes(folder.file("box.dat"));
  double sum = 0, area = 0;
  if (problem.plate()) {
    for (const auto& [node, force] : values) sum += force[problem.axis];
    return std::abs(bricks.copies() * sum);
  }
  const Vec3 along = problem.loads[0].traction.normalized();
  for (const auto& [node, share] : bricks.loads()) {
    sum += share * values.at(node).dot(along);
    area += share;
  }
  return sum / area;
}

}  // namespace incision::report
