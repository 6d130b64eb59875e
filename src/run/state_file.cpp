#include "incision/run/state_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <system_error>
#include <utility>

#include "incision/base/input_error.h"
#include "incision/base/printable.h"

namespace incision {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void failWith(int error) { throw std::system_error(error, std::generic_category()); }

/// An open file, if it is not negative.
struct Descriptor {
  explicit Descriptor(int opened) : file(opened) {}
  ~Descriptor() {
    if (file >= 0) close(file);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  const int file;
};

/// From a file.
void readNext(int file, char* to, std::size_t count) {
  for (std::size_t done = 0; done < count;) {
    const ssize_t more = ::read(file, to + done, count - done);
    if (more == 0 || (more < 0 && errno != EINTR)) throw InputError("cannot be read to its end");
    if (more > 0) done += static_cast<std::size_t>(more);
  }
}

std::string folderOf(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  return folder.empty() ? "." : folder.string();
}

}  // namespace

StateFile::StateFile(const std::string& path) : path_(path), unfinished_(path + ".tmp"), folder_(folderOf(path)) {
  std::error_code unknown;
  const fs::file_status at = fs::status(path, unknown);
  if (fs::exists(at) && !fs::is_regular_file(at))
    throw InputError(printable(path) + ": cannot be written: not a file (allowed: a file, or a new one in a folder)");
  file_ = open(unfinished_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file_ < 0) throw InputError(printable(path) + ": cannot be written: " + std::strerror(errno));
}

StateFile::~StateFile() {
  if (file_ < 0) return;
  close(file_);
  unlink(unfinished_.c_str());
}

void StateFile::write(const std::string& bytes) const {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::write(file_, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno != EINTR) failWith(errno);
    if (count > 0) done += static_cast<std::size_t>(count);
  }
}

void StateFile::save(const std::string& bytes) {
  const Descriptor folder(open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.file < 0) failWith(errno);
  write(bytes);
  // Or it would be written at the kernel's last tick, and perhaps no later than the file saved before.
  timespec now[2];
  clock_gettime(CLOCK_REALTIME, &now[0]);
  now[1] = now[0];
  futimens(file_, now);
  if (fsync(file_) != 0) failWith(errno);
  if (std::rename(unfinished_.c_str(), path_.c_str()) != 0) failWith(errno);
  close(std::exchange(file_, -1));
  // What has been renamed stays so when the power fails. EINVAL: a file system that cannot do that.
  if (fsync(folder.file) != 0 && errno != EINVAL) failWith(errno);
}

SavedState readState(const std::string& path, const SceneKey& key, int threads) {
  const std::string name = printable(path);
  std::error_code error;
  if (!fs::exists(path, error)) throw InputError(name + ": cannot be opened: no such file");
  if (!fs::is_regular_file(path, error)) throw InputError(name + ": not a file (allowed: that of a saved body)");
  const auto size = static_cast<std::size_t>(fs::file_size(path, error));
  const Descriptor from(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (error || from.file < 0) throw InputError(name + ": cannot be opened: " + std::strerror(errno));
  const auto read = [&](char* to, std::size_t count) { readNext(from.file, to, count); };
  try {
    return unpacked(read, size, key, threads);
  } catch (const InputError& wrong) {
    throw InputError(name + ": " + wrong.what());
  }
}

std::string restoreState(const std::string& path, const SceneKey& key, DeformableBody* body) {
  const SavedState state = readState(path, key, body->scene().solver.threads);
  try {
    body->restore(state.body);
    return state.leads;
  } catch (const InputError& wrong) {
    throw InputError(printable(path) + ": " + wrong.what());
  }
}

}  // namespace incision
