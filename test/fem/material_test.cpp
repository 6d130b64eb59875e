#include "incision/fem/material.h"

#include <gtest/gtest.h>

#include "support/section.h"

namespace incision {
namespace {

TEST(Material, ArrivesFromItsSection) {
  const Material material = parseMaterial(test::section(
      "material",
      "{young_modulus: 2e4, poisson_ratio: 0.3, density: 1050, mass_damping: 0.5, stiffness_damping: 0.01}"));
  EXPECT_EQ(material.young_modulus, 2e4);
  EXPECT_EQ(material.poisson_ratio, 0.3);
  EXPECT_EQ(material.density, 1050);
  EXPECT_EQ(material.mass_damping, 0.5);
  EXPECT_EQ(material.stiffness_damping, 0.01);
}

TEST(Material, BadValuesAreRefused) {
  test::expectRefused(parseMaterial, "material",
                      {{"{young_modulus: 0}", ".young_modulus"},
                       {"{young_modulus: 1e16}", ".young_modulus: '1e16' (allowed: 0.001 to 1e+15)"},
                       {"{poisson_ratio: -0.1}", ".poisson_ratio"},
                       {"{poisson_ratio: 0.5}", ".poisson_ratio: '0.5' (allowed: 0 to 0.4999)"},
                       {"{density: 0}", ".density"},
                       {"{mass_damping: -1}", ".mass_damping"},
                       {"{stiffness_damping: -1}", ".stiffness_damping"}});
}

}  // namespace
}  // namespace incision
