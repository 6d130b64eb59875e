#pragma once

#include <string>

namespace incision {

/// What a user wrote, fit for one line of a message: control characters become '?', long text is cut short.
std::string printable(const std::string& text);

}  // namespace incision
