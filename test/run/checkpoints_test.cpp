// Saved states by name, in memory and in a folder.
#include "incision/run/checkpoints.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "incision/base/input_error.h"
#include "support/batch_folder.h"

namespace incision {
namespace {

namespace fs = std::filesystem;

class CheckpointsTest : public BatchFolder {
 protected:
  void SetUp() override {
    BatchFolder::SetUp();
    scene_ = loadScene(file("bar.yaml"));
    body_ = std::make_unique<DeformableBody>(scene_, loadMesh(scene_));
    key_ = keyOf(*body_, {});
  }

  SavedState stepped() {
    body_->step();
    return savedState(*body_);
  }
  std::string checkpointFolder() const { return file("checkpoints"); }
  std::string pathOf(const std::string& name) const { return file("checkpoints/" + name + ".state"); }
  void writtenBefore(const std::string& name, int seconds) const {
    fs::last_write_time(pathOf(name), fs::last_write_time(pathOf(name)) - std::chrono::seconds(seconds));
  }

  template <class Call>
  static std::string complaintOf(Call call) {
    try {
      call();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  Scene scene_;
  std::unique_ptr<DeformableBody> body_;
  SceneKey key_;
};

TEST_F(CheckpointsTest, AreFoundAsTheyWereSaved) {
  for (const std::string& folder : {std::string(), checkpointFolder()}) {
    Checkpoints checkpoints(folder, key_, 1);
    SavedState first = stepped();
    first.leads = "led";
    checkpoints.save("first", first);
    const SavedState second = stepped();
    checkpoints.save("second", second);
    EXPECT_EQ(checkpoints.find("first").body, first.body);
    EXPECT_EQ(checkpoints.find("first").leads, "led");
    EXPECT_EQ(checkpoints.find("second").body, second.body);
    checkpoints.save("first", second);
    EXPECT_EQ(checkpoints.find("first").body, second.body);
    EXPECT_EQ(checkpoints.find("first").leads, "");
  }
}

TEST_F(CheckpointsTest, OfAFolderOutlastTheProcess) {
  const SavedState state = stepped();
  Checkpoints(checkpointFolder(), key_, 1).save("on", state);
  EXPECT_EQ(Checkpoints(checkpointFolder(), key_, 1).find("on").body, state.body);
}

TEST_F(CheckpointsTest, TheOldestLeaveTheMemoryAndAreNamed) {
  const SavedState state = stepped();
  const std::size_t size = packed(state, key_, 1).size();
  Checkpoints checkpoints("", key_, 1, 3 * size + size / 2);
  for (const char* name : {"a", "b", "c"}) EXPECT_TRUE(checkpoints.save(name, state).empty());
  EXPECT_TRUE(checkpoints.save("a", state).empty());  // now the newest
  EXPECT_EQ(checkpoints.save("d", state), std::vector<std::string>{"b"});
  EXPECT_EQ(complaintOf([&] { checkpoints.find("b"); }), "no checkpoint 'b' (there are: a, c, d)");
}

TEST_F(CheckpointsTest, TooLargeForTheMemoryNeedAFolder) {
  const SavedState state = stepped();
  EXPECT_NE(complaintOf([&] { Checkpoints("", key_, 1, 10).save("a", state); }).find("allowed: up to 10 in memory"),
            std::string::npos);
  Checkpoints in_folder(checkpointFolder(), key_, 1, 10);
  EXPECT_EQ(in_folder.save("a", state), std::vector<std::string>{"a"});
  EXPECT_EQ(in_folder.find("a").body, state.body);
}

TEST_F(CheckpointsTest, WithNamesThatAreNoneAreRefused) {
  Checkpoints checkpoints(checkpointFolder(), key_, 1);
  const SavedState state = stepped();
  for (const std::string& name : {std::string(), std::string("../up"), std::string("a b"), std::string("ü"),
                                  std::string("a\0b", 3), std::string(65, 'a'), std::string("a.state")}) {
    EXPECT_NE(complaintOf([&] { checkpoints.save(name, state); }), "") << name;
    EXPECT_NE(complaintOf([&] { checkpoints.find(name); }), "") << name;
  }
  for (const char* name : {"last", "autosave_1", "autosave_2"})
    EXPECT_NE(complaintOf([&] { checkpoints.save(name, state); }).find("a name that is taken"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(checkpointFolder()));
}

TEST_F(CheckpointsTest, SavedAutomaticallyAreTheLastTwo) {
  Checkpoints checkpoints(checkpointFolder(), key_, 1);
  std::vector<std::string> passed_over;
  EXPECT_FALSE(checkpoints.newest(&passed_over));
  std::vector<SavedState> states;
  for (int i = 0; i < 5; ++i) {
    states.push_back(stepped());
    checkpoints.autosave(states.back());
    for (const char* name : {"autosave_1", "autosave_2"})
      if (fs::exists(pathOf(name))) writtenBefore(name, 10);
    EXPECT_EQ(checkpoints.newest(&passed_over)->state.body, states.back().body);
    EXPECT_EQ(checkpoints.find("last").body, states.back().body);
  }
  fs::remove(pathOf(checkpoints.newest(&passed_over)->name));
  EXPECT_EQ(checkpoints.newest(&passed_over)->state.body, states[3].body);
  EXPECT_TRUE(passed_over.empty());
}

TEST_F(CheckpointsTest, ThatAreDamagedArePassedOverAndToldOf) {
  Checkpoints checkpoints(checkpointFolder(), key_, 1);
  const SavedState state = stepped();
  checkpoints.save("good", state);
  writtenBefore("good", 10);
  std::ofstream(pathOf("bad")) << "nothing";
  std::vector<std::string> passed_over;
  EXPECT_EQ(checkpoints.newest(&passed_over)->name, "good");
  ASSERT_EQ(passed_over.size(), 1u);
  EXPECT_EQ(passed_over[0].find(pathOf("bad") + ": "), 0u) << passed_over[0];
  fs::remove(pathOf("good"));
  EXPECT_EQ(complaintOf([&] { checkpoints.newest(&passed_over); }).find(pathOf("bad") + ": "), 0u);
}

TEST_F(CheckpointsTest, NeedAFolderOfTheirOwn) {
  const Checkpoints first(checkpointFolder(), key_, 1);
  EXPECT_NE(complaintOf([&] { Checkpoints(checkpointFolder(), key_, 1); }).find("another node has it"),
            std::string::npos);
  EXPECT_NE(complaintOf([&] { Checkpoints(file("bar.yaml"), key_, 1); }), "");
  EXPECT_NE(complaintOf([&] { Checkpoints(file("no/such"), key_, 1); }), "");
}

/// A process that is killed at any moment, in the middle of writing too, leaves whole files, the newest of which is the
/// last or the last but one that it can have written.
TEST_F(CheckpointsTest, SurviveThatTheProcessIsKilled) {
  for (int k = 0; k < 3; ++k) body_->step();
  std::int64_t before = 0;
  for (int round = 0; round < 40; ++round) {
    int told[2];
    ASSERT_EQ(pipe(told), 0);
    const pid_t child = fork();
    if (child == 0) {
      Checkpoints checkpoints(checkpointFolder(), key_, 1);
      for (std::int64_t number = before + 1;; ++number) {
        SavedState state = savedState(*body_);
        state.leads = std::to_string(number);
        checkpoints.autosave(state);
        if (write(told[1], &number, sizeof number) != sizeof number) _exit(1);
      }
    }
    ASSERT_GT(child, 0);
    close(told[1]);
    std::int64_t finished = before;
    ASSERT_EQ(read(told[0], &finished, sizeof finished), static_cast<ssize_t>(sizeof finished));
    std::this_thread::sleep_for(std::chrono::microseconds(137 * round));
    ASSERT_EQ(kill(child, SIGKILL), 0);
    waitpid(child, nullptr, 0);
    while (read(told[0], &finished, sizeof finished) == static_cast<ssize_t>(sizeof finished)) {
    }
    close(told[0]);
    Checkpoints checkpoints(checkpointFolder(), key_, 1);
    std::vector<std::string> passed_over;
    const auto newest = checkpoints.newest(&passed_over);
    ASSERT_TRUE(newest);
    EXPECT_TRUE(passed_over.empty());
    before = std::stoll(newest->state.leads);
    EXPECT_GE(before, finished);
    EXPECT_LE(before, finished + 1);
    body_->restore(newest->state.body);
  }
}

}  // namespace
}  // namespace incision
