#include "incision/run/batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "incision/base/input_error.h"
#include "incision/run/run_summary.h"
#include "incision/run/version.h"
#include "support/batch_folder.h"

namespace incision {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class Batch : public BatchFolder {};

TEST(BatchArguments, AreReadInAnyOrder) {
  const BatchOptions options =
      parseBatchArguments({"--steps", "7", "--set", "gravity=[0,0,0]", "scene.yaml", "--threads", "3", "--record",
                           "a.csv", "--positions", "b.txt", "--snapshot", "c.vtu"});
  EXPECT_EQ(options.scene, "scene.yaml");
  EXPECT_EQ(options.steps, 7);
  EXPECT_EQ(options.overrides, (std::vector<std::string>{"gravity=[0,0,0]", "solver.threads=3"}));
  EXPECT_EQ(options.record, "a.csv");
  EXPECT_EQ(options.positions, "b.txt");
  EXPECT_EQ(options.snapshot, "c.vtu");
}

TEST(BatchArguments, MistakesAreRefused) {
  const std::vector<std::vector<std::string>> mistakes = {{},
                                                          {""},
                                                          {"a.yaml", "b.yaml"},
                                                          {"a.yaml", "--step", "3"},
                                                          {"a.yaml", "--steps"},
                                                          {"a.yaml", "--steps", ""},
                                                          {"a.yaml", "--steps", "-1"},
                                                          {"a.yaml", "--steps", "1e3"},
                                                          {"a.yaml", "--steps", "3 "},
                                                          {"a.yaml", "--steps", "10000001"},
                                                          {"a.yaml", "--steps", "99999999999999999999"},
                                                          {"a.yaml", "--record"},
                                                          {"--steps", "3"}};
  for (const auto& arguments : mistakes) {
    EXPECT_THROW(parseBatchArguments(arguments), InputError) << (arguments.empty() ? "" : arguments.back());
  }
}

TEST_F(Batch, EndsWithOneLineOfJsonWithEveryKey) {
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "3"}), BatchStatus::DONE) << err_.str();
  EXPECT_EQ(out_.str().find('\n'), out_.str().size() - 1);
  const Json line = Json::parse(out_.str());
  std::set<std::string> keys;
  for (const auto& [key, value] : line.items()) keys.insert(key);
  EXPECT_EQ(keys, (std::set<std::string>{"scene",
                                         "set",
                                         "version",
                                         "interrupted",
                                         "failure",
                                         "cuts",
                                         "steps",
                                         "time",
                                         "bounds",
                                         "held_nodes",
                                         "nodes",
                                         "elements",
                                         "crack_elements",
                                         "parts",
                                         "copies",
                                         "dofs",
                                         "cracks",
                                         "pieces",
                                         "piece_volumes",
                                         "mass",
                                         "momentum",
                                         "kinetic_energy",
                                         "elastic_energy",
                                         "potential_energy",
                                         "contact_energy",
                                         "regions",
                                         "solves",
                                         "unsettled_steps",
                                         "max_displacement",
                                         "iterations",
                                         "residual",
                                         "step_ms",
                                         "phase_ms",
                                         "contacts",
                                         "peak_rss_mb",
                                         "state_hash"}));
  EXPECT_EQ(line["steps"], 3);
  EXPECT_EQ(line["nodes"], 20);
  EXPECT_EQ(line["elements"], 24);
  EXPECT_EQ(line["pieces"], 2);
  EXPECT_EQ(line["cracks"], 1);
  EXPECT_EQ(line["dofs"].get<int>(), 3 * line["copies"].get<int>());
  EXPECT_EQ(line["held_nodes"], 4);
  EXPECT_EQ(line["bounds"], Json::parse("[[0, 0, 0], [1, 0.25, 0.25]]"));
  EXPECT_EQ(line["momentum"].size(), 3u);
  EXPECT_EQ(line["state_hash"].get<std::string>().size(), 16u);
  EXPECT_GT(line["peak_rss_mb"].get<double>(), 1);
}

TEST_F(Batch, CutsThatMissAreToldOnStandardError) {
  run({file("bar.yaml"), "--steps", "3"});
  EXPECT_NE(err_.str().find("'beside' at 0.02 s missed"), std::string::npos) << err_.str();
  EXPECT_EQ(err_.str().find("'middle'"), std::string::npos) << err_.str();
}

TEST_F(Batch, TheJsonSaysWhatTheRunWas) {
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "3", "--set", "solver.time_step=0.005", "--threads", "2"}),
            BatchStatus::DONE);
  const Json line = Json::parse(out_.str());
  EXPECT_EQ(line["scene"], file("bar.yaml"));
  EXPECT_EQ(line["set"], Json::parse(R"(["solver.time_step=0.005", "solver.threads=2"])"));
  EXPECT_EQ(line["interrupted"], false);
  EXPECT_EQ(line["failure"], nullptr);
  EXPECT_EQ(line["version"], version());
  EXPECT_TRUE(std::regex_match(version(), std::regex("[-a-zA-Z0-9._+/]+ (plain|x86-64-v3|native)"))) << version();
}

TEST_F(Batch, TheJsonSaysWhatBecameOfEachCut) {
  for (const int steps : {0, 2, 3}) {
    ASSERT_EQ(run({file("bar.yaml"), "--steps", std::to_string(steps)}), BatchStatus::DONE);
    const Json cuts = Json::parse(out_.str())["cuts"];
    ASSERT_EQ(cuts.size(), 2u) << steps;
    EXPECT_EQ(cuts[0]["label"], "middle");
    EXPECT_EQ(cuts[0]["status"], steps < 3 ? "pending" : "applied");
    EXPECT_EQ(cuts[0]["reason"].get<std::string>().empty(), steps == 3);
    EXPECT_EQ(cuts[1]["label"], "beside");
    EXPECT_EQ(cuts[1]["status"], steps < 3 ? "pending" : "missed");
    EXPECT_NE(cuts[1]["reason"], "");
  }
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "3", "--set", "cuts.0.label=\"\\xff\""}), BatchStatus::DONE);
  EXPECT_EQ(Json::parse(out_.str())["cuts"].size(), 2u);
}

TEST_F(Batch, TheLineIsKeptWholeOrNotAtAll) {
  std::ofstream(file("end.json")) << "of an earlier run";
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "2", "--summary", file("end.json")}), BatchStatus::DONE);
  EXPECT_EQ(lines("end.json").at(0) + "\n", out_.str());
  EXPECT_EQ(run({file("bar.yaml"), "--steps", "2", "--summary", file("none/end.json")}), BatchStatus::BAD_INPUT);
  EXPECT_EQ(out_.str(), "");
  fs::create_directory(file("folder"));
  EXPECT_EQ(run({file("bar.yaml"), "--steps", "2", "--summary", file("folder")}), BatchStatus::FAILED);
  EXPECT_FALSE(fs::exists(file("folder.tmp")));
  EXPECT_NE(err_.str().find(file("folder") + ": could not be written"), std::string::npos) << err_.str();
  EXPECT_EQ(Json::parse(out_.str())["steps"], 2);
  // An error while it runs leaves what was there, and nothing beside it.
  EXPECT_EQ(run({file("bar.yaml"), "--summary", file("end.json"), "--save", file("none/a")}), BatchStatus::BAD_INPUT);
  EXPECT_EQ(lines("end.json").size(), 1u);
  EXPECT_FALSE(fs::exists(file("end.json.tmp")));
}

TEST_F(Batch, StrictRunsFailWithACutThatWasNotMade) {
  EXPECT_EQ(run({file("bar.yaml"), "--steps", "3", "--strict"}), BatchStatus::CUT_MISSED);
  EXPECT_EQ(Json::parse(out_.str())["steps"], 3);
  EXPECT_EQ(run({file("bar.yaml"), "--steps", "2", "--strict"}), BatchStatus::DONE);  // none was due
  EXPECT_EQ(run({file("bar.yaml"), "--steps", "3", "--strict", "--set", "cuts.1.point=[0.3,0,0]"}), BatchStatus::DONE);
}

TEST_F(Batch, AStepThatFailsEndsTheRunWithAStatusOfItsOwn) {
  const std::vector<std::string> fails = {file("bar.yaml"), "--steps",      "5", "--set", "gravity=[0,0,-1e308]",
                                          "--set",          "cuts.0.time=0"};
  EXPECT_EQ(run(fails), BatchStatus::STEP_FAILED);
  const Json line = Json::parse(out_.str());
  EXPECT_EQ(line["steps"], 0);
  EXPECT_EQ(line["failure"].get<std::string>().find("step 1 failed: "), 0u) << line["failure"];
  EXPECT_NE(err_.str().find(line["failure"].get<std::string>()), std::string::npos) << err_.str();
  EXPECT_EQ(line["interrupted"], false);
  EXPECT_EQ(line["cuts"][0]["status"], "applied");  // it took effect before the step
  EXPECT_EQ(line["cuts"][1]["status"], "pending");

  std::vector<std::string> going_on = fails;
  going_on.push_back("--keep-going");
  EXPECT_EQ(run(going_on), BatchStatus::DONE);
  EXPECT_EQ(Json::parse(out_.str())["failure"], line["failure"]);
}

TEST_F(Batch, SaysAtTheStartWhatTheBodyIs) {
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "0"}), BatchStatus::DONE) << err_.str();
  EXPECT_EQ(err_.str(),
            "incision_batch: a body of 24 elements in frame \"body\", from (0, 0, 0) to (1, 0.25, 0.25) m, of 62.5 kg, "
            "4 of its 20 nodes held\n");
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "0", "--set", "body.regions=[{box: [[0, 0, 0], [0.5, 1, 1]]}]", "--set",
                 "tools={knife: {type: blade, edge: [[0, 0, 0], [0, 0, 1]]}, awl: {type: blade, edge: [[0, 0, 0], [0, "
                 "0, 1]]}}"}),
            BatchStatus::DONE)
      << err_.str();
  EXPECT_NE(err_.str().find("4 of its 20 nodes held; regions: region_0; tools: awl (blade), knife (blade)\n"),
            std::string::npos)
      << err_.str();
}

TEST_F(Batch, SaysAfterTenStepsWhatPaceToExpect) {
  const std::string pace = "incision_batch: a step of 10 ms takes ";
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "9"}), BatchStatus::DONE) << err_.str();
  EXPECT_EQ(err_.str().find(pace), std::string::npos) << err_.str();
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "30"}), BatchStatus::DONE) << err_.str();
  EXPECT_NE(err_.str().find(pace), std::string::npos) << err_.str();
  EXPECT_EQ(err_.str().find(pace), err_.str().rfind(pace)) << err_.str();
}

TEST_F(Batch, SaysWhatOfTheMeshWasMendedAndLeavesStraysOutOfTheBounds) {
  std::ofstream(file("a.msh")) << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1000 0 0\n3 0 1000 0\n"
                                  "4 0 0 1000\n5 9 9 -9\n$EndNodes\n$Elements\n2\n1 4 2 1 1 1 2 4 3\n"
                                  "1 4 2 2 1 1 2 3 4\n$EndElements\n";
  std::ofstream(file("mesh.yaml")) << "body: {mesh: a.msh, scale: 0.001}\nboundary: [{group: 2}]\n";
  ASSERT_EQ(run({file("mesh.yaml"), "--steps", "0"}), BatchStatus::DONE) << err_.str();
  for (const char* said : {"a.msh: elements of negative volume", "a.msh: elements that repeat others",
                           "a.msh: nodes that are the corner of no tetrahedron"})
    EXPECT_NE(err_.str().find(said), std::string::npos) << err_.str();
  const Json line = Json::parse(out_.str());
  EXPECT_EQ(line["bounds"], Json::parse("[[0, 0, 0], [1, 1, 1]]"));
  EXPECT_EQ(line["held_nodes"], 4);
  EXPECT_EQ(line["nodes"], 5);
}

TEST_F(Batch, NoStepsOnlyLoadTheScene) {
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "0"}), BatchStatus::DONE) << err_.str();
  const Json line = Json::parse(out_.str());
  EXPECT_EQ(line["steps"], 0);
  EXPECT_EQ(line["pieces"], 1);
  EXPECT_EQ(line["max_displacement"], 0);
}

TEST_F(Batch, RecordHasOneRowAStep) {
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "4", "--record", file("run.csv")}), BatchStatus::DONE) << err_.str();
  const std::vector<std::string> rows = lines("run.csv");
  ASSERT_EQ(rows.size(), 5u);
  for (const std::string& row : rows) {
    EXPECT_EQ(std::count(row.begin(), row.end(), ','), std::count(rows[0].begin(), rows[0].end(), ',')) << row;
  }
  EXPECT_EQ(rows[1].substr(0, 2), "1,");
  EXPECT_EQ(rows[4].substr(0, 2), "4,");
}

// The columns of a record, by their names.
std::map<std::string, std::vector<double>> columnsOf(const std::vector<std::string>& rows) {
  const auto cells = [](const std::string& row) {
    std::vector<std::string> all;
    std::istringstream in(row);
    for (std::string cell; std::getline(in, cell, ',');) all.push_back(cell);
    return all;
  };
  const std::vector<std::string> names = cells(rows[0]);
  std::map<std::string, std::vector<double>> columns;
  for (std::size_t r = 1; r < rows.size(); ++r)
    for (std::size_t c = 0; c < names.size(); ++c) columns[names[c]].push_back(std::stod(cells(rows[r]).at(c)));
  return columns;
}

TEST_F(Batch, RecordTellsWhatClampsAndObstaclesBear) {
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "2", "--set", "contact.ground=-1", "--record", file("run.csv")}),
            BatchStatus::DONE)
      << err_.str();
  const auto columns = columnsOf(lines("run.csv"));
  for (const char* name : {"clamp_0_force_x", "clamp_0_torque_z", "ground_force_z"})
    EXPECT_EQ(columns.count(name), 1u) << name;
  EXPECT_LT(columns.at("clamp_0_force_z")[0], -1);  // [N]: a part of the weight, 613 N
}

// A blade goes down through the bar and cuts 0.25 m x 0.25 m against 40 N/m.
TEST_F(Batch, RecordTellsWhatTheTissueDoesToTheTool) {
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "30", "--set", "cuts=[]", "--set", "body.grid.cells=[4,4,4]", "--set",
                 "gravity=[0,0,0]", "--set",
                 "tools={scalpel: {type: blade, edge: [[0, -1, 0], [0, 1, 0]], cutting_force: 40, friction: 0, poses: "
                 "[[0, 0.6, 0, 0.5, 0, 0, 0, 1], "
                 "[0.3, 0.6, 0, -0.25, 0, 0, 0, 1]]}}",
                 "--record", file("run.csv")}),
            BatchStatus::DONE)
      << err_.str();
  const auto columns = columnsOf(lines("run.csv"));
  for (const char* name :
       {"tool_scalpel_force_x", "tool_scalpel_force_y", "tool_scalpel_torque_y", "tool_scalpel_torque_z"})
    EXPECT_EQ(columns.count(name), 1u) << name;
  const std::vector<double>&force = columns.at("tool_scalpel_force_z"), &torque = columns.at("tool_scalpel_torque_x"),
        &depth = columns.at("tool_scalpel_depth"), &area = columns.at("tool_scalpel_area");
  ASSERT_EQ(force.size(), 30u);
  EXPECT_EQ(force.front(), 0);  // still above
  EXPECT_EQ(depth.front(), 0);
  const std::size_t at = std::max_element(force.begin(), force.end()) - force.begin();
  const double station = 0.0625 / 16;  // of edge [m]: how exactly it is known at either end where it leaves the tissue
  EXPECT_NEAR(force[at], 40 * 0.25, 40 * 2 * station);           // upwards
  EXPECT_NEAR(torque[at], 0.125 * force[at], 40 * 2 * station);  // about the link's origin: the bar lies at y = 0.125
  const double deepest = *std::max_element(depth.begin(), depth.end());
  EXPECT_GT(deepest, 0.1);
  EXPECT_LT(deepest, 0.125 + 1e-9);  // in the middle of the bar
  EXPECT_EQ(force.back(), 0);        // it has come through
  EXPECT_NEAR(area.back(), 0.0625, 1e-6);
}

TEST_F(Batch, RecordHasNoToolWhereTheSceneHasNone) {
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "1", "--record", file("run.csv")}), BatchStatus::DONE) << err_.str();
  EXPECT_EQ(lines("run.csv")[0].find("tool"), std::string::npos) << lines("run.csv")[0];
}

TEST_F(Batch, WhatIsHardlyMeantSoIsWarnedOf) {
  run({file("bar.yaml"), "--steps", "0"});
  EXPECT_EQ(err_.str().find("warning"), std::string::npos) << err_.str();
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "0", "--set", "boundary.0.box=[[8, 8, 8], [9, 9, 9]]"}),
            BatchStatus::DONE);
  const std::string warnings =
      "incision_batch: warning: " + file("bar.yaml") +
      ": boundary.0: box [[8, 8, 8], [9, 9, 9]] has no node of the mesh: it holds nothing\n"
      "incision_batch: warning: nothing holds the body, neither a clamp nor contact: it falls\n";
  EXPECT_EQ(err_.str().substr(0, warnings.size()), warnings);
}

TEST_F(Batch, ClampsFollowThePosesOfAFile) {
  std::ofstream(file("poses.csv")) << "t,x,y,z,qx,qy,qz,qw\n0,5,0,0,0,0,0,1\n1,5,0,0.5,0,0,0,1\n";
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "4", "--set", "cuts=[]", "--set", "boundary.0.poses_file=poses.csv",
                 "--positions", file("end.txt")}),
            BatchStatus::DONE)
      << err_.str();
  std::istringstream first(lines("end.txt")[0]);
  double x = 1, y = 1, z = 0;
  first >> x >> y >> z;
  EXPECT_NEAR(x, 0, 1e-12);
  EXPECT_NEAR(y, 0, 1e-12);
  EXPECT_NEAR(z, 4 * 0.01 * 0.5, 1e-12);
  EXPECT_EQ(run({file("bar.yaml"), "--set", "boundary.0.poses_file=none.csv"}), BatchStatus::BAD_INPUT);
  EXPECT_NE(err_.str().find("none.csv: cannot be opened"), std::string::npos) << err_.str();
}

TEST_F(Batch, PositionsHaveOneLineANode) {
  ASSERT_EQ(run({file("bar.yaml"), "--steps", "4", "--positions", file("end.txt")}), BatchStatus::DONE) << err_.str();
  const std::vector<std::string> rows = lines("end.txt");
  ASSERT_EQ(rows.size(), 20u);
  for (const std::string& row : rows) {
    std::istringstream numbers(row);
    double x = NAN, y = NAN, z = NAN;
    numbers >> x >> y >> z;
    EXPECT_TRUE(std::isfinite(x + y + z) && numbers.eof()) << row;
  }
}

TEST_F(Batch, BadInputIsOneLineAndStatusTwo) {
  const std::vector<std::vector<std::string>> bad = {{"--frobnicate"},
                                                     {file("no_such.yaml")},
                                                     {file("bar.yaml"), "--set", "solver.time_step=2"},
                                                     {file("bar.yaml"), "--threads", "many"},
                                                     {file("bar.yaml"), "--series", file("run.vtu")},
                                                     {file("bar.yaml"), "--every", "0"},
                                                     {file("bar.yaml"), "--record", file("no/such/folder.csv")},
                                                     {file("bar.yaml"), "--positions", folder_.string()}};
  for (const auto& arguments : bad) {
    EXPECT_EQ(run(arguments), BatchStatus::BAD_INPUT) << arguments.back();
    EXPECT_EQ(out_.str(), "");
    EXPECT_EQ(err_.str().find('\n'), err_.str().size() - 1) << err_.str();
  }
}

TEST_F(Batch, FullDiskIsStatusOneAndStillReports) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  EXPECT_EQ(run({file("bar.yaml"), "--steps", "2", "--positions", "/dev/full"}), BatchStatus::FAILED);
  EXPECT_NE(err_.str().find("/dev/full"), std::string::npos);
  EXPECT_EQ(Json::parse(out_.str())["steps"], 2);
}

TEST_F(Batch, HelpNamesEveryOption) {
  EXPECT_EQ(run({"--help"}), BatchStatus::DONE);
  for (const char* option : {"--steps", "--set", "--threads", "--record", "--positions", "--snapshot", "--volume",
                             "--series", "--every", "--save", "--restore", "--summary", "--keep-going", "--strict"}) {
    EXPECT_NE(out_.str().find(option), std::string::npos) << option;
  }
}

TEST(StepStatistics, QuantilesAreNearestRanks) {
  StepStatistics statistics;
  EXPECT_EQ(statistics.quantile(0.5), 0);
  for (int ms = 100; ms >= 1; --ms) {
    StepResult step;
    step.step_ms = ms;
    step.phase_ms.solve = ms;
    statistics.add(step);
  }
  EXPECT_EQ(statistics.quantile(0.5), 50);
  EXPECT_EQ(statistics.quantile(0.99), 99);
  EXPECT_EQ(statistics.quantile(1), 100);
  EXPECT_EQ(statistics.meanPhases().solve, 50.5);
}

}  // namespace
}  // namespace incision
