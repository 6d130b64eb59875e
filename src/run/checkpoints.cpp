#include "incision/run/checkpoints.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>
#include <utility>

#include "incision/base/input_error.h"
#include "incision/base/printable.h"
#include "incision/run/state_file.h"

namespace incision {
namespace {

namespace fs = std::filesystem;

constexpr const char* EXTENSION = ".state";

const std::array<std::string, 2> AUTOSAVES = {"autosave_1", "autosave_2"};

/// Names of checkpoints that a message lists at most.
constexpr std::size_t MAX_LISTED = 10;

bool isAllowed(const std::string& name) {
  const auto isPlain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !name.empty() && name.size() <= MAX_CHECKPOINT_NAME && std::all_of(name.begin(), name.end(), isPlain);
}

void checkName(const std::string& name) {
  if (!isAllowed(name))
    throw InputError("no name of a checkpoint: '" + printable(name) + "' (allowed: up to " +
                     std::to_string(MAX_CHECKPOINT_NAME) + " letters, digits, _ and -)");
}

/// When a file was written last; long ago where it is not there.
fs::file_time_type written(const fs::path& path) {
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(path, error);
  return error ? fs::file_time_type::min() : time;
}

/// Takes the folder for this process, until the file returned is closed or the process ends in whatever way.
int lockFolder(const std::string& folder) {
  const std::string name = "the folder of checkpoints " + printable(folder) + ": ";
  std::error_code error;
  fs::create_directory(folder, error);
  const int file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) throw InputError(name + std::strerror(errno));
  if (flock(file, LOCK_EX | LOCK_NB) == 0 && access(folder.c_str(), W_OK) == 0) return file;
  const int why = errno;
  close(file);
  throw InputError(name + (why == EWOULDBLOCK ? "another node has it (allowed: one for each)" : std::strerror(why)));
}

}  // namespace

Checkpoints::Checkpoints(std::string folder, const SceneKey& key, int threads, std::size_t most_memory)
    : folder_(std::move(folder)), key_(key), threads_(threads), most_memory_(most_memory) {
  if (inFolder()) lock_ = lockFolder(folder_);
}

Checkpoints::~Checkpoints() {
  if (lock_ >= 0) close(lock_);
}

std::string Checkpoints::pathOf(const std::string& name) const { return (fs::path(folder_) / (name + EXTENSION)); }

std::shared_ptr<const std::string> Checkpoints::inMemory(const std::string& name) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const Kept& kept : kept_)
    if (kept.name == name) return kept.bytes;
  return nullptr;
}

std::vector<std::string> Checkpoints::keepInMemory(Kept kept) {
  const std::lock_guard<std::mutex> lock(mutex_);
  kept_.remove_if([&](const Kept& other) { return other.name == kept.name; });
  kept_.push_back(std::move(kept));
  std::size_t size = 0;
  for (const Kept& other : kept_) size += other.bytes->size();
  std::vector<std::string> gone;
  for (; size > most_memory_; kept_.pop_front()) {
    size -= kept_.front().bytes->size();
    gone.push_back(kept_.front().name);
  }
  return gone;
}

std::vector<std::string> Checkpoints::save(const std::string& name, const SavedState& state) {
  checkName(name);
  if (name == LAST_CHECKPOINT || std::count(AUTOSAVES.begin(), AUTOSAVES.end(), name) > 0)
    throw InputError("a name that is taken: '" + name + "' (allowed: another)");
  auto bytes = std::make_shared<const std::string>(packed(state, key_, threads_));
  if (bytes->size() > most_memory_ && !inFolder())
    throw InputError("the state takes " + std::to_string(bytes->size()) + " bytes (allowed: up to " +
                     std::to_string(most_memory_) + " in memory; give a checkpoint_folder)");
  if (inFolder()) StateFile(pathOf(name)).save(*bytes);
  return keepInMemory({name, std::move(bytes)});
}

SavedState Checkpoints::find(const std::string& name) const {
  checkName(name);
  const std::shared_ptr<const std::string> bytes = inMemory(name);
  if (bytes) return unpacked(*bytes, key_, threads_);
  std::error_code error;
  if (inFolder() && fs::exists(pathOf(name), error)) return readState(pathOf(name), key_, threads_);
  std::vector<std::string> passed_over;
  if (name == LAST_CHECKPOINT)
    if (std::optional<Newest> found = newest(&passed_over)) return std::move(found->state);
  throw InputError("no checkpoint '" + name + "' (there are: " + known() + ")");
}

void Checkpoints::autosave(const SavedState& state) const {
  const bool first_is_older = written(pathOf(AUTOSAVES[0])) < written(pathOf(AUTOSAVES[1]));
  StateFile(pathOf(AUTOSAVES[first_is_older ? 0 : 1])).save(packed(state, key_, threads_));
}

/// Names of the folder's, the newest first.
std::vector<std::string> Checkpoints::filesByAge() const {
  std::vector<std::pair<fs::file_time_type, std::string>> files;
  std::error_code error;
  for (fs::directory_iterator it(folder_, error), end; it != end && !error; it.increment(error)) {
    const fs::path path = it->path();
    if (path.extension() == EXTENSION && isAllowed(path.stem())) files.emplace_back(written(path), path.stem());
  }
  std::sort(files.rbegin(), files.rend());
  std::vector<std::string> names;
  names.reserve(files.size());
  for (const auto& [time, name] : files) names.push_back(name);
  return names;
}

std::optional<Checkpoints::Newest> Checkpoints::newest(std::vector<std::string>* passed_over) const {
  if (!inFolder()) throw InputError("no checkpoint_folder, where the last checkpoint would be");
  const std::vector<std::string> names = filesByAge();
  for (const std::string& name : names) {
    try {
      return Newest{name, readState(pathOf(name), key_, threads_)};
    } catch (const InputError& error) {
      passed_over->push_back(error.what());
    }
  }
  if (!names.empty()) throw InputError(passed_over->front());
  return std::nullopt;
}

std::string Checkpoints::known() const {
  std::set<std::string> names;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const Kept& kept : kept_) names.insert(kept.name);
  }
  if (inFolder())
    for (const std::string& name : filesByAge()) names.insert(name);
  if (names.empty()) return "none";
  std::string list;
  std::size_t listed = 0;
  for (const std::string& name : names) {
    if (++listed > MAX_LISTED) return list + ", …";
    list += (listed > 1 ? ", " : "") + name;
  }
  return list;
}

}  // namespace incision
