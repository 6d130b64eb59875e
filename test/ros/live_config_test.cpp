#include "incision/ros/live_config.h"

#include <gtest/gtest.h>
#include <incision/BodyConfig.h>

#include "incision/base/input_error.h"
#include "incision/scene/scene.h"

namespace incision {
namespace {

NodeLiveSettings atStart() { return {liveSettingsOf(Scene()), {}}; }

dynamic_reconfigure::Config said(const std::string& name, double value) {
  dynamic_reconfigure::Config message;
  message.doubles.emplace_back();
  message.doubles[0].name = name;
  message.doubles[0].value = value;
  return message;
}

std::string complaint(const std::string& name, double value) {
  try {
    changed(atStart(), said(name, value), "/node/set_parameters");
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(LiveConfig, ChangesWhatItNamesAlone) {
  NodeLiveSettings expected = atStart();
  expected.body.gravity.x() = 0.1;
  const NodeLiveSettings now = changed(atStart(), said("gravity_x", 0.1), "");
  EXPECT_EQ(now.body, expected.body);
  EXPECT_EQ(now.markers.rate, expected.markers.rate);
}

TEST(LiveConfig, OfAllSettingsGivesThem) {
  const NodeLiveSettings settings = {{1.0 / 3000, 7, Vec3(1.0 / 3, -2e-17, 1e8), 0.7}, {3.5, MarkerField::STRESS}};
  const NodeLiveSettings again = changed(atStart(), toConfig(settings), "");
  EXPECT_EQ(again.body, settings.body);
  EXPECT_EQ(again.markers.rate, 3.5);
  EXPECT_EQ(again.markers.field, MarkerField::STRESS);
}

TEST(LiveConfig, IsRefusedAsAtTheStart) {
  EXPECT_EQ(complaint("tolerance", 1), "/node/set_parameters: tolerance: '1' (allowed: 1e-12 to 0.1)");
  EXPECT_EQ(complaint("marker_rate", 1001), "/node/set_parameters: marker_rate: '1001' (allowed: 0 to 1000)");
  EXPECT_NE(complaint("gravity_z", std::nan("")).find("gravity_z: "), std::string::npos);
  EXPECT_NE(complaint("gravity_z", HUGE_VAL).find("(allowed: a finite number)"), std::string::npos);
  EXPECT_NE(complaint("gravty_z", 1).find("did you mean gravity_z?"), std::string::npos);
  EXPECT_EQ(complaint("threads", 2), "");
}

// What clients are told of ranges is what is refused: at each limit nothing is, and beyond it something, but where the
// parsers set no limit and what is told is only how far a slider goes.
TEST(LiveConfig, HasTheRangesThatClientsAreTold) {
  const auto& description = BodyConfig::__getDescriptionMessage__();
  for (const auto* limits : {&description.min, &description.max})
    for (const auto& parameter : limits->doubles) {
      EXPECT_EQ(complaint(parameter.name, parameter.value), "");
      const double sign = limits == &description.min ? -1 : 1;
      const bool has_limit =
          parameter.name.rfind("gravity", 0) != 0 && !(parameter.name == "cutting_force_factor" && sign > 0);
      const double beyond = parameter.value + sign * std::max(1e-13, 1e-3 * std::abs(parameter.value));
      EXPECT_EQ(complaint(parameter.name, beyond) != "", has_limit) << parameter.name << " " << beyond;
    }
  EXPECT_EQ(description.min.ints.at(0).value, 1);
  EXPECT_EQ(description.max.ints.at(0).value, SolverSettings::MAX_THREADS);
}

// The names, and the values at the start of a scene that says nothing of them.
TEST(LiveConfig, HasTheNamesAndDefaultsOfItsDescription) {
  const auto own = toConfig(atStart()), &told = BodyConfig::__getDescriptionMessage__().dflt;
  const auto expectAlike = [](const auto& a, const auto& b) {
    ASSERT_EQ(a.size(), b.size());
    for (const auto& x : a) {
      const auto y = std::find_if(b.begin(), b.end(), [&](const auto& other) { return other.name == x.name; });
      ASSERT_NE(y, b.end()) << x.name;
      EXPECT_EQ(x.value, y->value) << x.name;
    }
  };
  expectAlike(told.doubles, own.doubles);
  expectAlike(told.ints, own.ints);
  expectAlike(told.strs, own.strs);
  EXPECT_EQ(told.bools.size(), own.bools.size());
  EXPECT_EQ(told.groups.at(0).name, own.groups.at(0).name);
}

}  // namespace
}  // namespace incision
