#pragma once

#include <string>

#include "incision/run/saved_state.h"

namespace incision {

/// A file that a body is to be saved in. What is at its path stays as it is until the new file is whole.
class StateFile {
 public:
  /// Creates PATH.tmp, so that hours of a run are not lost to a misspelt folder. Throws InputError when that is not
  /// possible, or when the path is that of something other than a file.
  explicit StateFile(const std::string& path);
  /// Removes PATH.tmp where nothing was saved.
  ~StateFile();
  StateFile(const StateFile&) = delete;
  StateFile& operator=(const StateFile&) = delete;

  /// Writes what packed() has made and puts the file in its place, once. Throws std::system_error, with what is at the
  /// path unchanged, where the disk does not take it.
  void save(const std::string& bytes);

 private:
  void write(const std::string& bytes) const;

  // All that is needed to save or to give up: neither may find no memory.
  const std::string path_, unfinished_, folder_;
  int file_ = -1;
};

/// Reads such a file, on up to `threads` threads. Throws InputError with the file, what is wrong with it and what is
/// allowed, where it is cut short or damaged, of another format, or of another scene or mesh.
SavedState readState(const std::string& path, const SceneKey& key, int threads);

/// Restores a body from a file, as DeformableBody::restore does, and returns what led it; nothing where nothing did.
/// Throws InputError likewise, and where the file holds what no body can be: the body is then as it was.
std::string restoreState(const std::string& path, const SceneKey& key, DeformableBody* body);

}  // namespace incision
