#include "incision/fem/regions.h"

#include <gtest/gtest.h>

#include "incision/mesh/grid_mesh.h"

namespace incision {
namespace {

RegionSettings ofGroup(const std::string& group) {
  RegionSettings region;
  region.place.group = group;
  return region;
}

RegionSettings inBox(const Vec3& min, const Vec3& max) {
  RegionSettings region;
  region.place = {min, max};
  return region;
}

TEST(Regions, LaterOnesWinWhereTheyOverlap) {
  TetMesh mesh = gridMesh({{3, 1, 1}, Vec3(3, 1, 1), Vec3::Zero()});
  mesh.groups = {{"all", 1, 3, {}, {}, {}}, {"seventh", 2, 3, {}, {}, {7}}};
  for (int e = 0; e < 18; ++e) mesh.groups[0].elements.push_back(e);
  const Regions regions(mesh, {ofGroup("all"), inBox(Vec3(1, 0, 0), Vec3(3, 1, 1)), ofGroup("seventh")});
  EXPECT_EQ(regions.count(), 4);
  for (int e = 0; e < 18; ++e) EXPECT_EQ(regions.of(e), e == 7 ? 3 : e < 6 ? 1 : 2) << e;
  EXPECT_EQ(regions.name(0), "body");
  EXPECT_EQ(regions.name(1), "all");
  EXPECT_EQ(regions.name(2), "region_1");
}

TEST(Regions, WithoutSettingsAreOne) {
  const Regions regions;
  EXPECT_TRUE(regions.areOne());
  EXPECT_EQ(regions.count(), 1);
  EXPECT_EQ(regions.of(5), 0);
}

TEST(Regions, ValuesAreTheBodysWhereNoneIsSaid) {
  const TetMesh mesh = gridMesh({{1, 1, 1}, Vec3::Ones(), Vec3::Zero()});
  std::vector<RegionSettings> settings(2);
  settings[1].cutting_force = 60;
  const Regions regions(mesh, settings);
  EXPECT_EQ(regions.values(40.0, &RegionSettings::cutting_force), (std::vector<double>{40, 40, 60}));
  const std::vector<std::optional<double>> energies = {std::nullopt, std::nullopt, std::nullopt};
  EXPECT_EQ(regions.values(std::nullopt, &RegionSettings::fracture_energy), energies);
}

TEST(Regions, AGroupThatTheMeshDoesNotHaveIsRefusedWithAGuess) {
  TetMesh mesh = gridMesh({{1, 1, 1}, Vec3::Ones(), Vec3::Zero()});
  mesh.groups = {{"tumour", 1, 3, {}, {}, {0}}};
  RegionSettings region = ofGroup("tumor");
  region.place.said_at = "scene.yaml: body.regions.0";
  try {
    Regions regions(mesh, {region});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "scene.yaml: body.regions.0.group: 'tumor', did you mean tumour? (allowed: tumour)");
  }
}

}  // namespace
}  // namespace incision
