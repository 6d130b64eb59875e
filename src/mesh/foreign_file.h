#pragma once

#include <string>
#include <string_view>

namespace incision {

/// What a text is that is no Gmsh file with sections $MeshFormat and so on, and by which command it becomes one; empty
/// for one that begins like such a file.
std::string describeForeignFile(std::string_view text);

}  // namespace incision
