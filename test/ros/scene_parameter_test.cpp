#include "incision/ros/scene_parameter.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>

#include "incision/base/input_error.h"

namespace incision {
namespace {

using XmlRpc::XmlRpcValue;

TEST(SceneParameter, EveryTypeOfValueKeepsItsMeaning) {
  XmlRpcValue value;
  value["number"] = 0.1;
  value["whole"] = 3;
  value["text"] = std::string("1e6");
  value["switch"] = true;
  value["list"][0] = 1;
  value["list"][1]["key"] = std::string("a");
  value["infinite"] = HUGE_VAL;
  const YAML::Node node = toYaml(value, "scene");
  EXPECT_EQ(0.1, node["number"].as<double>());
  EXPECT_EQ(3, node["whole"].as<int>());
  EXPECT_EQ(1e6, node["text"].as<double>());
  EXPECT_TRUE(node["switch"].as<bool>());
  EXPECT_EQ("a", node["list"][1]["key"].as<std::string>());
  EXPECT_EQ(HUGE_VAL, node["infinite"].as<double>());
}

TEST(SceneParameter, BinaryDataIsAnErrorThatNamesItsKey) {
  char data[] = "x";
  XmlRpcValue value;
  value["body"]["mesh"] = XmlRpcValue(data, 1);
  try {
    toYaml(value, "/incision/scene");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(0u, std::string(error.what()).find("/incision/scene/body/mesh"));
  }
}

}  // namespace
}  // namespace incision
