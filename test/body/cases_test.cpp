#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>

#include "incision/mesh/grid_mesh.h"
#include "support/scenes.h"

namespace incision {
namespace {

const std::string CASES = INCISION_SOURCE_DIR "/test/cases/";

std::vector<std::string> caseNames() {
  std::vector<std::string> names;
  for (const auto& file : std::filesystem::directory_iterator(CASES))
    if (file.path().extension() == ".json") names.push_back(file.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

// Scenes with the results of a slow, independent implementation of the same method.
class Cases : public ::testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const std::string path = CASES + GetParam() + ".json";
    expected_ = YAML::LoadFile(path);
    scene_ = parseScene(expected_["scene"], path, CASES);
  }

  std::unique_ptr<DeformableBody> finish() {
    auto body = std::make_unique<DeformableBody>(scene_, loadMesh(scene_));
    test::run(body.get(), expected_["steps"].as<int>());
    return body;
  }

  double worstPosition(const DeformableBody& body) const {
    std::vector<Vec3> positions;
    for (const YAML::Node& p : expected_["positions"])
      positions.emplace_back(p[0].as<double>(), p[1].as<double>(), p[2].as<double>());
    return test::largestDifference(body.nodePositions(), positions);
  }

  // The longest side of the body's box.
  double size(const DeformableBody& body) const {
    Eigen::AlignedBox3d box;
    for (const Vec3& X : body.mesh().mesh().nodes) box.extend(X);
    return box.sizes().maxCoeff();
  }

  void expectCounts(const DeformableBody& body) const {
    EXPECT_EQ(body.counts().parts, expected_["parts"].as<int>());
    EXPECT_EQ(body.counts().copies, expected_["copies"].as<int>());
    EXPECT_EQ(body.counts().pieces, expected_["pieces"].as<int>());
  }

  YAML::Node expected_;
  Scene scene_;
};

TEST_P(Cases, AgreeWhenSolvedDirectly) {
  const auto body = finish();
  expectCounts(*body);

  const auto volumes = expected_["piece_volumes"].as<std::vector<double>>();
  double whole = 0;
  for (double volume : volumes) whole += volume;
  ASSERT_EQ(body->pieceVolumes().size(), volumes.size());
  for (std::size_t k = 0; k < volumes.size(); ++k) EXPECT_NEAR(body->pieceVolumes()[k], volumes[k], 1e-12 * whole);

  const BodyMotion motion = body->motion();
  const auto momentum = expected_["momentum"].as<std::vector<double>>();
  EXPECT_NEAR(motion.mass, expected_["mass"].as<double>(), 1e-12 * motion.mass);
  EXPECT_LT((motion.momentum - Vec3(momentum[0], momentum[1], momentum[2])).norm(), 1e-10 * motion.momentum.norm());
  // What two ways of adding up the same forces leave after some dozen steps; positions are given to 13 digits.
  EXPECT_LT(worstPosition(*body), 1e-10 * size(*body));
}

TEST_P(Cases, AgreeWhenSolvedIteratively) {
  scene_.solver.method = Method::ITERATIVE;
  scene_.solver.tolerance = 1e-6;
  const auto body = finish();
  expectCounts(*body);
  EXPECT_LT(worstPosition(*body), 1e-4 * size(*body));
}

INSTANTIATE_TEST_SUITE_P(, Cases, ::testing::ValuesIn(caseNames()), [](const auto& c) { return c.param; });

// The value on which SOFA and Vega agree, to the digits known of it.
TEST(UncutBar, SwingsAsInOtherPrograms) {
  Scene scene = test::softBar();
  scene.body.grid->cells = {16, 4, 4};
  scene.body.material.young_modulus = 1e6;
  scene.body.material.poisson_ratio = 0.45;
  scene.gravity = Vec3(0, 0, -9.81);
  scene.boundary = {test::clampLeftEnd()};
  DeformableBody body(scene, gridMesh(*scene.body.grid));
  test::run(&body, 200);
  const auto& nodes = body.mesh().mesh().nodes;
  const Vec3 tip(1, 0.125, 0.125);
  const auto at = std::find_if(nodes.begin(), nodes.end(), [&](const Vec3& X) { return (X - tip).norm() < 1e-9; });
  ASSERT_NE(at, nodes.end());
  const Vec3 moved = body.nodePositions()[at - nodes.begin()] - tip;
  EXPECT_LT((moved - Vec3(-0.009565, -0.032256, -0.126242)).cwiseAbs().maxCoeff(), 6e-7);
}

}  // namespace
}  // namespace incision
