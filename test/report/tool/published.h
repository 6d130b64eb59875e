#pragma once

#include <nlohmann/json.hpp>

namespace incision::report {

/// Forces of cuts that others have published, and those of the same cuts here.
nlohmann::json published(bool quick);

}  // namespace incision::report
