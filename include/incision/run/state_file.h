#pragma once

#include <cstdint>
#include <string>

#include "incision/run/scene_key.h"

namespace incision {

/// The number of the form in which bodies are saved. It grows with every change of what outlasts a step, and of the
/// file round it.
inline constexpr std::uint32_t STATE_FORMAT = 1;

/// A file that a body is to be saved in. What is at its path stays as it is until the new file is whole.
class StateFile {
 public:
  /// Creates PATH.tmp, so that hours of a run are not lost to a misspelt folder. Throws InputError when that is not
  /// possible, or when the path is that of something other than a file.
  explicit StateFile(const std::string& path);
  /// Removes PATH.tmp where nothing was saved.
  ~StateFile();
  StateFile(StateFile&& other) noexcept;
  StateFile(const StateFile&) = delete;
  StateFile& operator=(const StateFile&) = delete;

  /// Saves the body and puts the file in its place, once. Throws std::system_error, with what is at the path unchanged,
  /// where the disk does not take it.
  void save(const DeformableBody& body, const SceneKey& key);

 private:
  void write(const std::string& bytes) const;

  std::string path_;
  int file_ = -1;
};

/// Restores a body from a file, as DeformableBody::restore does. Throws InputError with the file, what is wrong with it
/// and what is allowed, and with the body as it was: where the file is cut short or damaged, of another format, of
/// another scene or mesh, or holds what no body can be.
void restoreState(const std::string& path, const SceneKey& key, DeformableBody* body);

}  // namespace incision
