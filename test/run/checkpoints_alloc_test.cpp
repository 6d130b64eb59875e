// What is left of saving and restoring in which memory runs out, wherever that is: nothing, in memory or in a folder.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <new>
#include <set>

#include "incision/base/input_error.h"
#include "incision/run/checkpoints.h"
#include "incision/run/state_file.h"
#include "support/allocation_hooks.h"
#include "support/batch_folder.h"
#include "support/sanitized.h"

namespace incision::test {
namespace {

namespace fs = std::filesystem;

/// Checkpoints and a body, all that a call may change.
struct Place {
  Checkpoints* checkpoints;
  DeformableBody* body;
};

std::string toText(const SavedState& state) {
  return state.leads + ' ' + std::to_string(std::hash<std::string>()(state.body));
}

/// A call that is disturbed. It returns what it has found.
struct Scenario {
  const char* name;
  bool in_folder;
  std::function<std::string(const Place& place)> call;
};

class CheckpointsWithoutMemory : public BatchFolder {
 protected:
  void SetUp() override {
    BatchFolder::SetUp();
    scene_ = loadScene(file("bar.yaml"));
    body_ = std::make_unique<DeformableBody>(scene_, loadMesh(scene_));
    key_ = keyOf(*body_, {});
    for (SavedState& state : states_) {
      for (int k = 0; k < 3; ++k) body_->step();
      state = savedState(*body_);
      state.leads = std::to_string(body_->steps());
    }
    most_memory_ = 5 * packed(states_[0], key_, 1).size() / 2;
  }

  std::string folder() const { return file("checkpoints"); }

  /// Two that were saved by a user, of which one more has no room beside them, and one by itself.
  std::unique_ptr<Checkpoints> checkpoints(bool in_folder) {
    fs::remove_all(folder());
    auto all = std::make_unique<Checkpoints>(in_folder ? folder() : "", key_, 2, most_memory_);
    if (in_folder) all->autosave(states_[2]);
    all->save("older", states_[0]);
    all->save("newer", states_[1]);
    return all;
  }

  /// All that there is: in memory, in the folder, and of the body. A file that is not whole cannot be read.
  std::string seen(const Checkpoints& all, const DeformableBody& body) const {
    std::string text = std::to_string(body.stateHash());
    for (const char* name : {"older", "newer", "fresh"}) {
      try {
        text += '\n' + std::string(name) + ' ' + toText(all.find(name));
      } catch (const InputError&) {
      }
    }
    if (!all.inFolder()) return text;
    std::set<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(folder())) paths.insert(entry.path());
    for (const fs::path& path : paths) text += '\n' + path.string() + ' ' + toText(readState(path, key_, 1));
    return text;
  }

  std::vector<Scenario> scenarios() const;
  std::string end(const Scenario& scenario, const std::function<std::string(const Place& place)>& call);
  std::int64_t refuse(const Scenario& scenario, const std::string& undisturbed, std::int64_t n, std::int64_t count);
  void expectUndisturbed(int every);

  Scene scene_;
  std::unique_ptr<DeformableBody> body_;
  SceneKey key_;
  SavedState states_[4];
  std::size_t most_memory_ = 0;
};

std::vector<Scenario> CheckpointsWithoutMemory::scenarios() const {
  std::vector<Scenario> all;
  for (const bool in_folder : {false, true}) {
    all.push_back({"save", in_folder, [this](const Place& place) {
                     const std::vector<std::string> gone = place.checkpoints->save("fresh", states_[3]);
                     return gone.size() == 1 ? gone[0] : "";
                   }});
    all.push_back({"save over another", in_folder, [this](const Place& place) {
                     return place.checkpoints->save("older", states_[3]).empty() ? "" : "gone";
                   }});
    all.push_back({"find", in_folder, [](const Place& place) { return toText(place.checkpoints->find("older")); }});
    all.push_back({"restore", in_folder, [](const Place& place) {
                     place.body->restore(place.checkpoints->find("newer").body);
                     return std::string();
                   }});
  }
  all.push_back(
      {"find the last", true, [](const Place& place) { return toText(place.checkpoints->find(LAST_CHECKPOINT)); }});
  all.push_back({"find what only a file has", true,
                 [](const Place& place) { return toText(place.checkpoints->find("autosave_2")); }});
  all.push_back({"save by itself", true, [this](const Place& place) {
                   place.checkpoints->autosave(states_[3]);
                   return std::string();
                 }});
  all.push_back({"save from the body", true, [this](const Place& place) {
                   StateFile(folder() + "/older.state").save(packed(savedState(*place.body), key_, 2));
                   return std::string();
                 }});
  all.push_back({"restore from a file", true,
                 [this](const Place& place) { return restoreState(folder() + "/newer.state", key_, place.body); }});
  return all;
}

/// What there is after a call.
std::string CheckpointsWithoutMemory::end(const Scenario& scenario,
                                          const std::function<std::string(const Place& place)>& call) {
  const auto all = checkpoints(scenario.in_folder);
  body_->restore(states_[0].body);
  const std::string found = call({all.get(), body_.get()});
  return found + '\n' + seen(*all, *body_);
}

/// So many allocations from the n-th on. Returns how many there were.
std::int64_t CheckpointsWithoutMemory::refuse(const Scenario& scenario, const std::string& undisturbed, std::int64_t n,
                                              std::int64_t count) {
  std::int64_t refused = 0;
  const auto call = [&](const Place& place) {
    const std::string before = seen(*place.checkpoints, *place.body);
    std::string found;
    bool failed = false;
    refused = refusing(n, count, [&] {
      try {
        found = scenario.call(place);
      } catch (const std::bad_alloc&) {
        failed = true;
      }
    });
    if (!failed) return found;  // it did without
    EXPECT_EQ(seen(*place.checkpoints, *place.body), before) << scenario.name << ", number " << n;
    return scenario.call(place);
  };
  EXPECT_EQ(end(scenario, call), undisturbed) << scenario.name << ", number " << n;
  return refused;
}

void CheckpointsWithoutMemory::expectUndisturbed(int every) {
  for (const Scenario& scenario : scenarios()) {
    const std::string undisturbed = end(scenario, scenario.call);
    // Some that follow each other too: then even what cleans up has none.
    std::int64_t n = 1;
    while (refuse(scenario, undisturbed, n, n % 2 == 1 ? 1 : 20) > 0 && !HasFailure()) n += every;
    EXPECT_GT(n, 1) << scenario.name;
    std::printf("%s%s: %d\n", scenario.name, scenario.in_folder ? " in a folder" : "", static_cast<int>(n));
  }
}

TEST_F(CheckpointsWithoutMemory, AreAsIfTheCallHadNotBeenTried) { expectUndisturbed(SANITIZED ? 29 : 7); }

TEST_F(CheckpointsWithoutMemory, FullAreAsIfTheCallHadNotBeenTried) { expectUndisturbed(1); }

}  // namespace
}  // namespace incision::test
