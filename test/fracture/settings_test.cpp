#include "incision/fracture/settings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/section.h"

namespace incision {
namespace {

TEST(FractureSettings, ArriveFromTheirSection) {
  const FractureSettings fracture =
      parseFracture(test::section("fracture",
                                  "{tensile_strength: 1e5, compressive_strength: '.inf', crack_speed: 20, "
                                  "fuse_distance: 0.01, fuse_angle: 0.5, fracture_energy: 30}"));
  EXPECT_EQ(fracture.tensile_strength, 1e5);
  EXPECT_TRUE(std::isinf(fracture.compressive_strength));
  EXPECT_EQ(fracture.crack_speed, 20);
  EXPECT_EQ(fracture.fuse_distance, 0.01);
  EXPECT_EQ(fracture.fuse_angle, 0.5);
  EXPECT_EQ(fracture.fracture_energy, 30);
}

TEST(FractureSettings, BadValuesAreRefused) {
  test::expectRefused([](const YamlValue& value) { return parseFracture(value); }, "fracture",
                      {{"{}", ": needs a tensile_strength or a compressive_strength"},
                       {"{tensile_strength: .inf}", ": needs a tensile_strength"},
                       {"{tensile_strength: 0}", ".tensile_strength"},
                       {"{tensile_strength: -1e5}", ".tensile_strength"},
                       {"{tensile_strength: .nan}", ".tensile_strength"},
                       {"{tensile_strength: strong}", ".tensile_strength"},
                       {"{compressive_strength: -.inf}", ".compressive_strength"},
                       {"{crack_speed: 0}", ".crack_speed"},
                       {"{crack_speed: [1]}", ".crack_speed"},
                       {"{fuse_distance: -1}", ".fuse_distance"},
                       {"{fuse_distance: .inf}", ".fuse_distance"},
                       {"{fuse_angle: 1.6}", ".fuse_angle"},
                       {"{tensile_strength: 1, fracture_energy: 0}", ".fracture_energy"},
                       {"{compressive_strength: 1, fracture_energy: 1}", ".fracture_energy: needs a tensile_strength"},
                       {"{toughness: 1}", ".toughness: unknown key"}});
}

TEST(FractureSettings, OneRegionThatBreaksIsEnough) {
  std::vector<RegionSettings> regions(2);
  regions[1].place.said_at = "scene.yaml: body.regions.1";
  const auto parse = [&](const std::string& text) { return parseFracture(test::section("fracture", text), regions); };
  EXPECT_THROW(parse("{}"), InputError);
  regions[1].compressive_strength = 1e5;
  EXPECT_TRUE(std::isinf(parse("{}").tensile_strength));
  regions[1].fracture_energy = 10;
  try {
    parse("{}");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "scene.yaml: body.regions.1.fracture_energy: needs a tensile_strength, here or of the body");
  }
  regions[1].tensile_strength = 1e4;
  EXPECT_NO_THROW(parse("{}"));
}

}  // namespace
}  // namespace incision
