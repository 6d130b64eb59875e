#pragma once

#include <nlohmann/json.hpp>

namespace incision::report {

/// Errors of stress intensities and of energy release rates over meshes of several sizes.
nlohmann::json roundCracks(bool quick);

}  // namespace incision::report
