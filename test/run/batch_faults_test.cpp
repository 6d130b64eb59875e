// What the batch program makes of disks and signals.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "incision/run/state_file.h"
#include "support/batch_folder.h"
#include "support/sanitized.h"

namespace incision {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

class BatchFaults : public BatchFolder {
 protected:
  /// The program, whose standard output and error go to `end.json` and `err`, with so many bytes of addresses.
  pid_t start(std::vector<std::string> arguments, rlim_t most_memory = RLIM_INFINITY) const {
    const std::string program = fs::read_symlink("/proc/self/exe").parent_path() / "incision_batch";
    arguments.insert(arguments.begin(), program);
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child != 0) return child;
    if (!std::freopen(file("end.json").c_str(), "w", stdout) || !std::freopen(file("err").c_str(), "w", stderr))
      _exit(99);
    const rlimit limit = {most_memory, most_memory};
    setrlimit(RLIMIT_AS, &limit);
    execv(argv[0], argv.data());
    _exit(99);
  }

  std::string errors() const {
    std::string all;
    for (const std::string& line : lines("err")) all += line + "\n";
    return all;
  }
};

TEST_F(BatchFaults, ASignalEndsARunWithinAStepWithAllThatWasRecordedWhole) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const pid_t child = start({file("bar.yaml"), "--steps", "10000000", "--set", "body.grid.cells=[12,6,6]", "--record",
                               file("run.csv"), "--save", file("end.state")});
    ASSERT_GT(child, 0);
    const auto deadline = std::chrono::steady_clock::now() + 60s;
    while (!fs::exists(file("run.csv")) || lines("run.csv").size() < 6) {
      ASSERT_LT(std::chrono::steady_clock::now(), deadline) << errors();
      std::this_thread::sleep_for(2ms);
    }
    ASSERT_EQ(kill(child, signal), 0);
    const std::size_t taken = lines("run.csv").size();  // and a row that is being written
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 128 + signal) << status << errors();

    const std::vector<std::string> rows = lines("run.csv");
    EXPECT_LE(rows.size(), taken + 2);
    for (const std::string& row : rows)
      EXPECT_EQ(std::count(row.begin(), row.end(), ','), std::count(rows[0].begin(), rows[0].end(), ',')) << row;
    const nlohmann::json end = nlohmann::json::parse(lines("end.json").at(0));
    EXPECT_EQ(end["steps"].get<std::size_t>(), rows.size() - 1);
    EXPECT_EQ(end["interrupted"], true);
    EXPECT_EQ(
        run({file("bar.yaml"), "--steps", "0", "--set", "body.grid.cells=[12,6,6]", "--restore", file("end.state")}),
        BatchStatus::DONE)
        << err_.str();
    EXPECT_EQ(nlohmann::json::parse(out_.str())["state_hash"], end["state_hash"]);
    fs::remove(file("run.csv"));
  }
}

TEST_F(BatchFaults, FullRunsThatNobodyWatchesSayHowFarTheyAreEveryTenSeconds) {
  const auto start_time = std::chrono::steady_clock::now();
  const pid_t child = start({file("bar.yaml"), "--steps", "10000000", "--set", "cuts=[]"});
  ASSERT_GT(child, 0);
  const auto said = [&] { return static_cast<int>(lines("err").size()) - 2; };  // beside what the body is and its pace
  while (said() < 2) {
    ASSERT_LT(std::chrono::steady_clock::now() - start_time, 60s) << errors();
    std::this_thread::sleep_for(5ms);
  }
  EXPECT_GT(std::chrono::steady_clock::now() - start_time, 19s) << errors();
  EXPECT_EQ(said(), 2);
  EXPECT_EQ(lines("err").at(2).find("incision_batch: step "), 0u) << errors();
  EXPECT_NE(lines("err").at(2).find(" of 10000000, "), std::string::npos) << errors();
  kill(child, SIGTERM);
  waitpid(child, nullptr, 0);
}

/// Under limits from where nothing can be loaded to where all fits: no run waits for memory, or ends otherwise than it
/// should.
TEST_F(BatchFaults, WhereMemoryIsShortARunEndsAndSaysSo) {
  if (test::SANITIZED) GTEST_SKIP() << "shadow memory needs more than any limit";
  int done = 0, failed = 0;
  for (const char* method : {"direct", "iterative"})
    for (rlim_t mebibytes = 60; mebibytes <= 460; mebibytes += 40) {
      const pid_t child = start({file("bar.yaml"), "--steps", "4", "--threads", "2", "--set",
                                 "body.grid.cells=[20,8,8]", "--set", std::string("solver.method=") + method},
                                mebibytes << 20);
      const auto deadline = std::chrono::steady_clock::now() + 60s;
      int status = 0;
      while (waitpid(child, &status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > deadline) kill(child, SIGKILL);
        std::this_thread::sleep_for(2ms);
      }
      const bool well = WIFEXITED(status) && WEXITSTATUS(status) == static_cast<int>(BatchStatus::DONE);
      ++(well ? done : failed);
      if (well || (WIFEXITED(status) && WEXITSTATUS(status) == 127))
        continue;  // 127: its libraries could not be loaded
      EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == static_cast<int>(BatchStatus::FAILED))
          << method << " in " << mebibytes << " MiB: " << status << errors();
      EXPECT_NE(errors().find("not enough memory for this scene"), std::string::npos) << errors();
    }
  EXPECT_GT(done, 2);
  EXPECT_GT(failed, 4);
}

TEST_F(BatchFaults, ADiskThatIsFullIsToldOfAndTheRunGoesToItsEnd) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "needs /dev/full";
  for (const char* option : {"--record", "--positions", "--snapshot", "--volume"}) {
    EXPECT_EQ(run({file("bar.yaml"), "--steps", "3", option, "/dev/full"}), BatchStatus::FAILED) << option;
    EXPECT_NE(err_.str().find("/dev/full: could not be written to the end"), std::string::npos) << err_.str();
    EXPECT_EQ(nlohmann::json::parse(out_.str())["steps"], 3) << option;
  }
}

TEST_F(BatchFaults, AFolderThatGoesAwayIsToldOfAndTheRunGoesToItsEnd) {
  fs::create_directory(file("gone"));
  const pid_t child = start({file("bar.yaml"), "--steps", "300", "--set", "body.grid.cells=[12,6,6]", "--series",
                             file("gone/run.pvd"), "--every", "5", "--save", file("gone/end.state")});
  ASSERT_GT(child, 0);
  const auto deadline = std::chrono::steady_clock::now() + 60s;
  while (!fs::exists(file("gone/run_surface_00000005.vtu"))) {
    ASSERT_LT(std::chrono::steady_clock::now(), deadline) << errors();
    std::this_thread::sleep_for(2ms);
  }
  fs::rename(file("gone"), file("moved"));
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == static_cast<int>(BatchStatus::FAILED)) << status << errors();
  EXPECT_NE(errors().find(file("gone/end.state") + ": could not be written"), std::string::npos) << errors();
  EXPECT_NE(errors().find(file("gone/run.pvd") + ": could not be written to the end"), std::string::npos) << errors();
  EXPECT_EQ(nlohmann::json::parse(lines("end.json").at(0))["steps"], 300);
}

}  // namespace
}  // namespace incision
