#pragma once

#include <functional>
#include <nlohmann/json.hpp>

namespace incision::report {

/// Puts into the data what a section's text, plots and claims are drawn from; the keys are the section's own.
using Measure = std::function<void(bool quick, nlohmann::json* data)>;

/// What main() of a section's program does and returns: `program [--quick] FILE.json` writes the data to the file.
int writeSection(int argc, char** argv, const Measure& measure);

}  // namespace incision::report
