#pragma once

#include <exception>
#include <new>

namespace incision {

/// What to tell a user of an exception, which must outlive this. It takes no memory, of which there may be none.
inline const char* whyOf(const std::exception& error) {
  return dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? "memory ran out" : error.what();
}

}  // namespace incision
