#pragma once

#include <optional>
#include <string>
#include <vector>

#include "incision/fem/mass.h"
#include "incision/fem/material.h"
#include "incision/fem/pressure.h"
#include "incision/fem/region_settings.h"
#include "incision/mesh/grid_settings.h"
#include "incision/mesh/placed_mesh.h"

namespace incision {

struct BodySettings {
  std::vector<PlacedMesh> meshes;    ///< mesh files; or
  std::optional<GridSettings> grid;  ///< exactly one of the two is given
  std::string frame = "body";        ///< tf frame of the body's coordinates
  Material material;
  std::vector<RegionSettings> regions = {};  ///< later ones win where they overlap
  bool warping = true;
  Mass mass = Mass::LUMPED;
  Pressure pressure = Pressure::ELEMENT;
};

/// The section `body`. Throws InputError.
BodySettings parseBody(const YamlValue& value);

}  // namespace incision
