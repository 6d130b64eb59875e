#include "incision/fem/region_settings.h"

#include <gtest/gtest.h>

#include "support/section.h"

namespace incision {
namespace {

TEST(RegionSettings, ArriveFromTheirEntry) {
  const RegionSettings region = parseRegion(test::section(
      "body.regions.0",
      "{group: tumour, material: {young_modulus: 5e4, poisson_ratio: 0.3, density: 1100}, "
      "cutting_force: 60, cutting_viscosity: 2, cutting_onset: 30, tensile_strength: 2e4, compressive_strength: .inf, "
      "fracture_energy: 40}"));
  EXPECT_EQ(region.place.group, "tumour");
  EXPECT_EQ(region.place.said_at, "scene.yaml: body.regions.0");
  EXPECT_EQ(region.young_modulus, 5e4);
  EXPECT_EQ(region.poisson_ratio, 0.3);
  EXPECT_EQ(region.density, 1100);
  EXPECT_EQ(region.cutting_force, 60);
  EXPECT_EQ(region.cutting_viscosity, 2);
  EXPECT_EQ(region.cutting_onset, 30);
  EXPECT_EQ(region.tensile_strength, 2e4);
  EXPECT_TRUE(std::isinf(*region.compressive_strength));
  EXPECT_EQ(region.fracture_energy, 40);
}

TEST(RegionSettings, SayNothingThatIsNotGiven) {
  const RegionSettings region = parseRegion(test::section("body.regions.0", "{box: [[0, 0, 0], [1, 1, 1]]}"));
  EXPECT_EQ(region.place.box.max, Vec3::Ones());
  for (const auto& value : {region.young_modulus, region.poisson_ratio, region.density, region.tensile_strength,
                            region.compressive_strength, region.fracture_energy, region.cutting_force,
                            region.cutting_viscosity, region.cutting_onset})
    EXPECT_FALSE(value);
}

TEST(RegionSettings, BadValuesAreRefused) {
  const auto with = [](const std::string& entry) { return "{group: a, " + entry + "}"; };
  test::expectRefused(parseRegion, "body.regions.0",
                      {{"{}", ": needs a group or a box"},
                       {with("box: [[0, 0, 0], [1, 1, 1]]"), ": needs a group or a box"},
                       {with("material: {mass_damping: 1}"), ".material.mass_damping: unknown key"},
                       {with("material: {young_modulus: 0}"), ".material.young_modulus"},
                       {with("material: {poisson_ratio: 0.5}"), ".material.poisson_ratio"},
                       {with("tensile_strength: 0"), ".tensile_strength"},
                       {with("fracture_energy: .inf"), ".fracture_energy"},
                       {with("cutting_force: -1"), ".cutting_force"},
                       {with("cutting_viscosity: -1"), ".cutting_viscosity"},
                       {with("cutting_onset: -1"), ".cutting_onset"}});
}

}  // namespace
}  // namespace incision
