#include "incision/ros/bag/bag_reader.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>

#include "incision/base/input_error.h"
#include "incision/base/printable.h"

namespace incision {
namespace {

/// Most names of topics in one message.
constexpr std::size_t MOST_NAMES = 20;

std::string joined(const std::set<std::string>& names) {
  std::string text;
  std::size_t count = 0;
  for (const std::string& name : names) {
    if (++count > MOST_NAMES) return text + ", and " + std::to_string(names.size() - MOST_NAMES) + " more";
    text += (text.empty() ? "" : ", ") + printable(name);
  }
  return text.empty() ? "none" : text;
}

/// As the node would see it: old tools leave the first slash out.
std::string fullName(const std::string& topic) { return topic.empty() || topic.front() != '/' ? "/" + topic : topic; }

Nanoseconds toNanoseconds(const ros::Time& time) { return static_cast<Nanoseconds>(time.toNSec()); }

enum class Trial { PASSED, THREW, DIED };

/// How the task ends in another process. rosbag trusts the offsets in a file, and a damaged one could end this process.
template <class Task>
Trial tryElsewhere(const Task& task) {
  const pid_t child = fork();
  if (child < 0) return Trial::THREW;  // no room for a process: it is tried here
  if (child == 0) {
    try {
      task();
      _exit(EXIT_SUCCESS);
    } catch (...) {
      _exit(EXIT_FAILURE);
    }
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  if (!WIFEXITED(status)) return Trial::DIED;
  return WEXITSTATUS(status) == EXIT_SUCCESS ? Trial::PASSED : Trial::THREW;
}

}  // namespace

BagReader::BagReader(const std::string& path, const std::vector<BagTopic>& topics) : path_(path), topics_(topics) {
  if (!std::filesystem::is_regular_file(path)) throw InputError(printable(path) + ": there is no such file");
  const Trial trial = tryElsewhere([this] {
    open();
    readAll();
  });
  if (trial == Trial::DIED) throw InputError(printable(path) + ": the bag is damaged (rosbag check says more)");
  try {
    open();
    if (trial != Trial::PASSED) readAll();
  } catch (const rosbag::BagUnindexedException&) {
    throw InputError(printable(path) + ": it is cut short, or has not been closed (rosbag reindex mends that)");
  } catch (const rosbag::BagException& error) {
    throw InputError(printable(path) + ": not a whole bag: " + printable(error.what()));
  }
  at_ = view_->begin();
}

void BagReader::open() {
  if (bag_.isOpen()) bag_.close();
  bag_.open(path_, rosbag::bagmode::Read);
  rosbag::View all(bag_);
  if (all.size() == 0) throw InputError(printable(path_) + ": there is no message in it");
  begin_ = toNanoseconds(all.getBeginTime());
  end_ = toNanoseconds(all.getEndTime());
  find(all);
  const auto is_found = [this](const rosbag::ConnectionInfo* connection) {
    return found_.count(connection->topic) > 0;
  };
  view_ = std::make_unique<rosbag::View>(bag_, is_found);
}

void BagReader::find(rosbag::View& all) {
  std::set<std::string> there, looked_for;
  bool of_scene = false;
  found_.clear();
  for (const rosbag::ConnectionInfo* connection : all.getConnections()) {
    there.insert(connection->topic);
    for (const BagTopic& topic : topics_) {
      if (topic.name != fullName(connection->topic)) continue;
      if (topic.md5sum != connection->md5sum)
        throw InputError(printable(path_) + ": topic " + printable(connection->topic) + " has messages of type " +
                         printable(connection->datatype) + ", or of another version of it (allowed: " + topic.type +
                         ")");
      found_[connection->topic] = &topic;
      of_scene = of_scene || topic.of_scene;
    }
  }
  for (const BagTopic& topic : topics_)
    if (topic.of_scene) looked_for.insert(topic.name);
  if (!of_scene)
    throw InputError(printable(path_) + ": nothing in it is for this scene (there: " + joined(there) +
                     "; looked for: " + joined(looked_for) + ")");
}

void BagReader::read(const rosbag::MessageInstance& message, const SteadyTime* received) const {
  try {
    found_.at(message.getTopic())->read(message, received);
  } catch (const InputError&) {
    throw;
  } catch (const std::exception& error) {
    std::ostringstream text;
    text << printable(path_) << ": the message on " << printable(message.getTopic()) << " of " << message.getTime()
         << " s is damaged: " << printable(error.what());
    throw InputError(text.str());
  }
}

bool BagReader::has(const std::string& topic) const {
  return std::any_of(found_.begin(), found_.end(), [&](const auto& entry) { return entry.second->name == topic; });
}

void BagReader::readAll() {
  for (const rosbag::MessageInstance& message : *view_) read(message, nullptr);
}

SteadyTime BagReader::next() const {
  return at_ == view_->end() ? SteadyTime::max() : toSteady(toNanoseconds(at_->getTime()));
}

void BagReader::deliver() {
  const SteadyTime received = next();
  read(*at_, &received);
  ++at_;
  ++delivered_;
}

}  // namespace incision
