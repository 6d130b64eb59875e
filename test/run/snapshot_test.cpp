#include "incision/run/snapshot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "support/batch_folder.h"

namespace incision {
namespace {

using Json = nlohmann::json;

class Snapshots : public BatchFolder {};

TEST_F(Snapshots, SnapshotHasAStressForEveryTriangle) {
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "4", "--snapshot", file("end.vtu")}), BatchStatus::DONE) << err_.str();
  const std::vector<std::string> rows = lines("end.vtu");
  std::size_t triangles = 0, stresses = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t count = rows[i].find("NumberOfCells=\"");
    if (count != std::string::npos) triangles = std::stoul(rows[i].substr(count + 15));
    if (rows[i].find("Name=\"stress\"") == std::string::npos) continue;
    while (rows[i + 1 + stresses] != "</DataArray>") ++stresses;
  }
  EXPECT_GT(triangles, 0u);
  EXPECT_EQ(stresses, triangles);
  EXPECT_EQ(rows.back(), "</VTKFile>");
}

// The rows of a VTK array.
std::vector<std::vector<double>> arrayOf(const std::vector<std::string>& lines, const std::string& name) {
  std::vector<std::vector<double>> rows;
  auto line = std::find_if(lines.begin(), lines.end(), [&](const std::string& text) {
    return text.find("Name=\"" + name + "\"") != std::string::npos;
  });
  EXPECT_NE(line, lines.end()) << name;
  for (++line; *line != "</DataArray>"; ++line) {
    std::istringstream numbers(*line);
    rows.emplace_back(std::istream_iterator<double>(numbers), std::istream_iterator<double>());
  }
  return rows;
}

// Of a cell from its faces, by the divergence theorem: "how many faces, then of each how many points and which".
double volumeOf(const std::vector<double>& faces, const std::vector<std::vector<double>>& points) {
  const auto point = [&](std::size_t k) {
    const auto& p = points[static_cast<std::size_t>(faces[k])];
    return Vec3(p[0], p[1], p[2]);
  };
  double volume = 0;
  for (std::size_t k = 1; k < faces.size(); k += 1 + static_cast<std::size_t>(faces[k]))
    for (std::size_t i = k + 2; i < k + static_cast<std::size_t>(faces[k]); ++i)
      volume += point(k + 1).dot(point(i).cross(point(i + 1))) / 6;
  return volume;
}

TEST_F(Snapshots, TheVolumesCellsFillTheBody) {
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "3", "--volume", file("end.vtu"), "--set", "gravity=[0,0,0]", "--set",
                 "cuts.0.normal=[1,0.3,0.2]", "--set", "body.regions=[{box: [[0.5, 0, 0], [1, 1, 1]]}]"}),
            BatchStatus::DONE)
      << err_.str();
  const auto rows = lines("end.vtu");
  const auto points = arrayOf(rows, "Points"), cells = arrayOf(rows, "connectivity"), faces = arrayOf(rows, "faces"),
             types = arrayOf(rows, "types"), regions = arrayOf(rows, "region");
  std::map<int, double> volumes;  // of each region
  int polyhedra = 0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto& c = cells[i];
    const bool cut = types[i][0] == 42;
    ASSERT_EQ(cut, !faces[i].empty());
    polyhedra += cut;
    const std::vector<double> of_tetrahedron = {4, 3,    c[1], c[2], c[3], 3,    c[0], c[3], c[2],
                                                3, c[0], c[1], c[3], 3,    c[0], c[2], c[1]};
    const double volume = volumeOf(cut ? faces[i] : of_tetrahedron, points);
    EXPECT_GT(volume, 0);
    volumes[static_cast<int>(regions[i][0])] += volume;
  }
  EXPECT_GT(polyhedra, 4);
  const Json regions_told = Json::parse(out_.str())["regions"];
  EXPECT_NEAR(volumes[0], 0.03125, 1e-12);
  EXPECT_NEAR(volumes[1], 0.03125, 1e-12);
  EXPECT_NEAR(regions_told["body"], 0.03125, 1e-12);
  EXPECT_NEAR(regions_told["region_0"], 0.03125, 1e-12);
  for (const auto& u : arrayOf(rows, "displacement")) EXPECT_LT(std::abs(u[0]) + std::abs(u[1]), 1e-9);
}

TEST_F(Snapshots, ASeriesListsTheSnapshotsItHas) {
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "5", "--series", file("run.pvd"), "--every", "2"}), BatchStatus::DONE);
  std::vector<std::string> files;
  for (const std::string& row : lines("run.pvd"))
    if (const auto at = row.find("file=\""); at != std::string::npos)
      files.push_back(row.substr(at + 6, row.find('"', at + 6) - at - 6));
  EXPECT_EQ(files.size(), 8u);  // of steps 0, 2, 4 and 5, surface and volume
  for (const std::string& name : files) EXPECT_EQ(lines(name).back(), "</VTKFile>") << name;
  EXPECT_EQ(lines("run.pvd").back(), "</VTKFile>");
}

}  // namespace
}  // namespace incision
