#pragma once

#include "incision/base/line_reader.h"
#include "mesh_builder.h"

namespace incision {

/// Takes a Gmsh ASCII file, version 2.2 or 4.1, apart: hands its nodes and elements to the builder.
void readGmshSections(LineReader& reader, MeshBuilder& builder);

}  // namespace incision
