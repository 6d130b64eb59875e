#pragma once

#include <nlohmann/json.hpp>

namespace incision::report {

/// A ball in a matrix that is stretched alike in all directions: errors by contrast, mesh and size.
nlohmann::json studyBall(bool quick);

/// Cantilevers of layers: errors of the deflection by contrast and size.
nlohmann::json studyLayers(bool quick);

/// Bodies of parts whose field linear elements have exactly: what is left of an error.
nlohmann::json studyExact(bool quick);

}  // namespace incision::report
