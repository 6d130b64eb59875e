#include "incision/base/yaml_reader.h"

#include <gtest/gtest.h>

#include "support/section.h"

namespace incision {
namespace {

using test::complaint;
using test::expectRefused;
using test::section;

double positive(const YamlValue& value) { return value.number(POSITIVE); }
YamlMap oneOrTwo(const YamlValue& value) { return value.map({"first", "second"}); }
std::string frame(const YamlValue& value) { return value.frame(); }
std::string path(const YamlValue& value) { return value.path(); }

TEST(YamlReader, TextThatReadsAsANumberIsANumber) {
  EXPECT_EQ(section("a", "'1e6'").number(), 1e6);
  EXPECT_EQ(section("a", "+2.5E2").number(), 250);
  EXPECT_EQ(section("a", "'.inf'").numberOrInfinity(POSITIVE), std::numeric_limits<double>::infinity());
  EXPECT_EQ(section("a", "3e0").integer(1, 3), 3);
  EXPECT_EQ(section("a", "'1'").integer(1, 3), 1);
}

TEST(YamlReader, WhatIsNoFiniteNumberInTheRangeIsRefused) {
  for (const char* bad : {"0", "-1", ".nan", ".inf", "soft", "1e6 Pa", "1e999", "''", "", "[1]", "{a: 1}", "true"}) {
    EXPECT_EQ(complaint(positive, "a", bad).find("scene.yaml: a: "), 0u) << bad;
  }
}

TEST(YamlReader, MessagesNameSourceKeyValueAndWhatIsAllowed) {
  EXPECT_EQ(complaint(positive, "a", "0"), "scene.yaml: a: '0' (allowed: above 0)");
  EXPECT_EQ(complaint(positive, "a", "[1, 2]"), "scene.yaml: a: a list of 2 (allowed: above 0)");
  EXPECT_EQ(complaint(positive, "a", "\"x\\ny\""), "scene.yaml: a: 'x?y' (allowed: above 0)");
}

TEST(YamlReader, MapsHaveKnownKeysOnce) {
  expectRefused(oneOrTwo, "a",
                {{"{first: 1, first: 2}", ".first: given twice (allowed: once)"},
                 {"{[1]: 2}", ": a key that is not text (allowed: first, second)"},
                 {"{frist: 1}", ".frist: unknown key, did you mean first? (allowed: first, second)"},
                 {"{other: 1}", ".other: unknown key (allowed: first, second)"},
                 {"[0]", ": a list of 1 (allowed: a map with first, second)"}});
  EXPECT_FALSE(oneOrTwo(section("a", "")).has("first"));
}

TEST(YamlReader, NamedEntriesComeByNameWhateverTheOrder) {
  const auto entries = section("a", "{liver: 1, gall_2: 2, B-1: 3}").named(3);
  std::vector<std::string> names;
  for (const auto& [name, value] : entries) names.push_back(name);
  EXPECT_EQ(names, (std::vector<std::string>{"B-1", "gall_2", "liver"}));
  EXPECT_EQ(entries.at("liver").number(), 1);
  EXPECT_EQ(entries.at("liver").where(), "scene.yaml: a.liver");
  const auto two = [](const YamlValue& value) { return value.named(2); };
  expectRefused(two, "a",
                {{"{}", ": a map (allowed: a map of 1 to 2 names)"},
                 {"{b: 1, c: 2, d: 3}", ": a map (allowed: a map of 1 to 2 names)"},
                 {"[1]", ": a list of 1 (allowed: a map of 1 to 2 names)"},
                 {"{'b c': 1}", ": the name 'b c' (allowed: 1 to 255 letters, digits, _, -)"},
                 {"{[1]: 1}", ": the name ''"},
                 {"{b: 1, b: 2}", ".b: given twice (allowed: once)"}});
}

TEST(YamlReader, FramesAreNamesWithoutALeadingSlash) {
  EXPECT_EQ(frame(section("a", std::string(MAX_NAME, 'x'))), std::string(MAX_NAME, 'x'));
  expectRefused(frame, "a", {{"/knife", ": '/knife'"}, {"''", ": ''"}, {std::string(MAX_NAME + 1, 'x'), ": 'xxx"}});
}

TEST(YamlReader, PathsAreTakenFromTheFolder) {
  EXPECT_EQ(path(section("a", "meshes/a.msh")), "/folder/meshes/a.msh");
  EXPECT_EQ(path(section("a", "/other/a.msh")), "/other/a.msh");
  expectRefused(path, "a",
                {{"''", ": ''"},
                 {"http://host/a.msh", ": 'http"},
                 {"package://no_such_package/a.msh", ": package no_such_package not found"}});
}

}  // namespace
}  // namespace incision
