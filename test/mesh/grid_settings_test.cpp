#include "incision/mesh/grid_settings.h"

#include <gtest/gtest.h>

#include "support/section.h"

namespace incision {
namespace {

TEST(GridSettings, ArriveFromTheirSection) {
  const GridSettings grid =
      parseGrid(test::section("grid", "{cells: [16, 4, 2], size: [1, 0.25, 0.5], origin: [-1, 2, 3]}"));
  EXPECT_EQ(grid.cells, (std::array<int, 3>{16, 4, 2}));
  EXPECT_EQ(grid.size, Vec3(1, 0.25, 0.5));
  EXPECT_EQ(grid.origin, Vec3(-1, 2, 3));
}

TEST(GridSettings, BadValuesAreRefused) {
  test::expectRefused(parseGrid, "grid",
                      {{"{}", ": the key cells is missing"},
                       {"{cells: [1, 1]}", ".cells: a list of 2"},
                       {"{cells: [0, 1, 1]}", ".cells.0"},
                       {"{cells: [1.5, 1, 1]}", ".cells.0"},
                       {"{cells: [1e99, 1, 1]}", ".cells.0"},
                       {"{cells: [1, 1, 1], size: [1, 0, 1]}", ".size.1"}});
}

}  // namespace
}  // namespace incision
