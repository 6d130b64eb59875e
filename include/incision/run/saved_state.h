#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "incision/run/scene_key.h"

namespace incision {

/// The number of the form in which bodies are saved. It grows with every change of what outlasts a step, and of the
/// file round it.
inline constexpr std::uint32_t STATE_FORMAT = 5;

/// A body between two steps, as bytes.
struct SavedState {
  std::string body;   ///< as DeformableBody::save writes it
  std::string leads;  ///< how the node was leading tools and links on; empty where nothing did
};

/// Of a body that nothing leads. Throws std::bad_alloc.
SavedState savedState(const DeformableBody& body);

/// The bytes of a file that holds a saved body, on up to `threads` threads:
///
///   magic, 8 bytes | format, 4 | length of the header, 4 | hash of these and of the header, 8 | header | sections
///
/// The header says of what scene, mesh and version the body is, and of each section how long it is as it is stored and
/// unpacked, and its hash. Numbers are in the order of little-endian machines. Hashes are XXH3's of 64 bits. Throws
/// std::length_error for a body that takes more than one of this mesh may.
std::string packed(const SavedState& state, const SceneKey& key, int threads);

/// What has been packed. `read` gives the next bytes of the file, of which there are `size`; nothing is allocated
/// before it is known that the file can hold as much, and no more is unpacked than a body of this mesh can be. Throws
/// InputError with what is wrong.
SavedState unpacked(const std::function<void(char* to, std::size_t count)>& read, std::size_t size, const SceneKey& key,
                    int threads);
SavedState unpacked(std::string_view file, const SceneKey& key, int threads);

}  // namespace incision
