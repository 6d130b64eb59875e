#include "incision/run/checkpoints.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <new>
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

[[noreturn]] void failAt(const std::string& folder, const std::string& why) {
  throw InputError("the folder of checkpoints " + printable(folder) + ": " + why);
}

/// Names of what is in a folder. Not by std::filesystem, which ends the process where it finds no memory for that.
std::vector<std::string> filesOf(const std::string& folder) {
  const std::unique_ptr<DIR, int (*)(DIR*)> all(opendir(folder.c_str()), &closedir);
  if (!all && errno == ENOMEM) throw std::bad_alloc();
  if (!all) failAt(folder, std::strerror(errno));
  std::vector<std::string> names;
  while (const dirent* entry = readdir(all.get())) names.emplace_back(entry->d_name);
  return names;
}

/// Takes the folder for this process, until the file returned is closed or the process ends in whatever way.
int lockFolder(const std::string& folder) {
  std::error_code error;
  fs::create_directory(folder, error);
  const int file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) failAt(folder, std::strerror(errno));
  if (flock(file, LOCK_EX | LOCK_NB) == 0 && access(folder.c_str(), W_OK) == 0) return file;
  const int why = errno;
  close(file);
  failAt(folder, why == EWOULDBLOCK ? "another node has it (allowed: one for each)" : std::strerror(why));
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

/// Moves one there, of which nothing fails, and names what has to leave for it. `gone` has room for all names.
void Checkpoints::keepInMemory(std::list<Kept>* kept, std::vector<std::string>* gone) {
  const std::lock_guard<std::mutex> lock(mutex_);
  kept_.remove_if([&](const Kept& other) { return other.name == kept->front().name; });
  kept_.splice(kept_.end(), *kept);
  std::size_t size = 0;
  for (const Kept& other : kept_) size += other.bytes->size();
  for (; size > most_memory_; kept_.pop_front()) {
    size -= kept_.front().bytes->size();
    gone->push_back(std::move(kept_.front().name));
  }
}

std::vector<std::string> Checkpoints::save(const std::string& name, const SavedState& state) {
  checkName(name);
  if (name == LAST_CHECKPOINT || std::count(AUTOSAVES.begin(), AUTOSAVES.end(), name) > 0)
    throw InputError("a name that is taken: '" + name + "' (allowed: another)");
  const auto bytes = std::make_shared<const std::string>(packed(state, key_, threads_));
  if (bytes->size() > most_memory_ && !inFolder())
    throw InputError("the state takes " + std::to_string(bytes->size()) + " bytes (allowed: up to " +
                     std::to_string(most_memory_) + " in memory; give a checkpoint_folder)");
  // What takes memory comes first, so that all is done where the file is.
  const std::lock_guard<std::mutex> saving(saving_);
  std::vector<std::string> gone;
  gone.reserve(kept_.size() + 1);
  std::list<Kept> kept = {{name, bytes}};
  if (inFolder()) StateFile(pathOf(name)).save(*bytes);
  keepInMemory(&kept, &gone);
  return gone;
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
  for (const std::string& file : filesOf(folder_)) {
    const fs::path path = fs::path(folder_) / file;
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
