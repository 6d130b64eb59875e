#pragma once

#include <cstddef>
#include <string>

namespace incision {

/// A scene or a description is refused beyond this size [bytes]: what people write is a hundredth of it, and
/// their parsers take memory and stack in proportion.
inline constexpr std::size_t MAX_TEXT = std::size_t{1} << 20;

/// The whole of a text file. Throws InputError when it cannot be read or is larger than `max_bytes`.
std::string readText(const std::string& path, std::size_t max_bytes = MAX_TEXT);

}  // namespace incision
