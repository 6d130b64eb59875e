#pragma once

#include <string>

namespace incision {

/// What must be known of a COLLADA text before a library reads it that calls itself for every node within a node and
/// makes room for all that is promised: throws InputError, in words that go on after the file's name, where elements
/// are nested too deeply, nodes that are instances of others go in a circle or come to too many, or a count is of more
/// numbers than the text can hold.
void checkCollada(const std::string& text);

}  // namespace incision
