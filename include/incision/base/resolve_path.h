#pragma once

#include <string>

namespace incision {

/// Absolute path of a `package://` address, an absolute path, or a path relative to `folder`. Throws InputError when
/// the package is not found.
std::string resolvePath(const std::string& address, const std::string& folder);

}  // namespace incision
