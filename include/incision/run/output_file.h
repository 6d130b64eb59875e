#pragma once

#include <fstream>
#include <string>

namespace incision {

/// Creates or empties a text file for numbers of 17 digits. Throws InputError when that is not possible.
std::ofstream openOutput(const std::string& path);

}  // namespace incision
