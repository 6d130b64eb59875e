#pragma once

#include <string>

namespace incision {

/// What must be known of a COLLADA text before a library reads it that calls itself for every node within a node:
/// throws InputError, in words that go on after the file's name, where elements are nested too deeply, or nodes that
/// are instances of others go in a circle or come to too many.
void checkCollada(const std::string& text);

}  // namespace incision
