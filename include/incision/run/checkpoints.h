#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "incision/run/saved_state.h"

namespace incision {

/// Most bytes of checkpoints kept in memory: hundreds of a body of a hundred thousand elements, and less than what such
/// a body itself takes.
inline constexpr std::size_t MAX_CHECKPOINT_MEMORY = std::size_t{1} << 30;

/// Characters of a name: no file system has trouble with as many.
inline constexpr std::size_t MAX_CHECKPOINT_NAME = 64;

/// The name that stands for the newest checkpoint of a folder.
inline constexpr const char* LAST_CHECKPOINT = "last";

/// Saved states of one body by name: in memory, and where there is a folder also in files NAME.state there, which
/// outlast the process. Thread-safe.
class Checkpoints {
 public:
  /// `folder` is made where it is not there; empty: only in memory. `most_memory` [bytes]. Throws InputError where the
  /// folder cannot be used, or another process uses it.
  Checkpoints(std::string folder, const SceneKey& key, int threads, std::size_t most_memory = MAX_CHECKPOINT_MEMORY);
  ~Checkpoints();
  Checkpoints(const Checkpoints&) = delete;
  Checkpoints& operator=(const Checkpoints&) = delete;

  bool inFolder() const { return !folder_.empty(); }

  /// Keeps the state, in place of one of the same name. Returns the names of the oldest ones that had to leave the
  /// memory for it. Throws InputError for a name that is not allowed and where the memory does not hold the state, and
  /// std::system_error where the disk does not take it, and std::bad_alloc: then what was there before is unchanged.
  std::vector<std::string> save(const std::string& name, const SavedState& state);

  /// Throws InputError for a name that is not allowed, is not there, or whose file cannot be used. The name `last`
  /// stands for the newest.
  SavedState find(const std::string& name) const;

  /// Keeps the state in the folder, in place of the last but one that was kept by this function. Throws
  /// std::system_error where the disk does not take it.
  void autosave(const SavedState& state) const;

  /// A checkpoint as it was found.
  struct Newest {
    std::string name;
    SavedState state;
  };
  /// The newest in the folder that can be used; none where there is none at all. `passed_over` gets a line for each
  /// newer one that cannot be used. Throws InputError where there are some and none can be used.
  std::optional<Newest> newest(std::vector<std::string>* passed_over) const;

 private:
  struct Kept {
    std::string name;
    std::shared_ptr<const std::string> bytes;
  };
  std::string pathOf(const std::string& name) const;
  std::shared_ptr<const std::string> inMemory(const std::string& name) const;
  void keepInMemory(std::list<Kept>* kept, std::vector<std::string>* gone);
  std::string known() const;
  std::vector<std::string> filesByAge() const;

  const std::string folder_;
  const SceneKey key_;
  const int threads_;
  const std::size_t most_memory_;
  int lock_ = -1;      // on the folder
  std::mutex saving_;  // only who has it changes what is kept
  mutable std::mutex mutex_;
  std::list<Kept> kept_;  // the oldest first
};

}  // namespace incision
