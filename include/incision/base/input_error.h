#pragma once

#include <stdexcept>

namespace incision {

/// Something a user wrote cannot be used: a file, a scene, a command. The message names the file, the line or key,
/// the value, and what is allowed.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace incision
