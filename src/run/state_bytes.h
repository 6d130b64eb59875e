#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "incision/run/state_file.h"

namespace incision {

/// The bytes of a file that holds a saved body, on up to `threads` threads:
///
///   magic, 8 bytes | format, 4 | length of the header, 4 | hash of these and of the header, 8 | header | sections
///
/// The header says of what scene, mesh and version the body is, and of each section how long it is as it is stored and
/// unpacked, and its hash. Numbers are in the order of little-endian machines. Hashes are XXH3's of 64 bits.
std::string packed(const std::string& body, const SceneKey& key, int threads);

/// What has been packed. `read` gives the next bytes of the file, of which there are `size`; nothing is allocated
/// before it is known that the file can hold as much, and no more is unpacked than a body of this mesh can be. Throws
/// InputError with what is wrong.
std::string unpacked(const std::function<void(char* to, std::size_t count)>& read, std::size_t size,
                     const SceneKey& key, int threads);

}  // namespace incision
