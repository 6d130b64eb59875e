#pragma once

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "incision/mesh/mesh_io.h"

namespace incision {

/// The mesh of a Gmsh file's text, which errors call a.msh.
inline TetMesh read(const std::string& text, MeshRepairs* repairs = nullptr) {
  std::istringstream in(text);
  return readGmsh(in, "a.msh", repairs);
}

/// The text with something else in place of what is found first.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// What reading it complains of.
inline std::string errorOf(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace incision
