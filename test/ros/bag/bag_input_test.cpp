#include <rosgraph_msgs/Clock.h>

#include <utility>

#include "bag_run.h"
#include "support/sanitized.h"

namespace incision {
namespace {

class BagInput : public BagRun {
 protected:
  /// Changes every so many bytes of a bag, one at a time.
  void expectReadOrRefused(const std::string& bag, const std::string& scene, std::size_t every) {
    if (test::SANITIZED) GTEST_SKIP() << "rosbag reads past its buffers; what it then does is the sanitizer's to stop";
    const std::string good = bytesOf(bag);
    int refused = 0;
    for (std::size_t i = 13; i < good.size(); i += every) {
      std::string bytes = good;
      bytes[i] = static_cast<char>(bytes[i] ^ 0xFF);
      std::ofstream(file("changed.bag"), std::ios::binary) << bytes;
      const BatchStatus status = runBag({file("changed.bag"), file(scene), "--steps", "0"});
      if (status == BatchStatus::DONE) continue;
      ++refused;
      EXPECT_EQ(status, BatchStatus::BAD_INPUT) << i;
      EXPECT_EQ(err_.str().find('\n'), err_.str().size() - 1) << i << ": " << err_.str();
    }
    EXPECT_GT(refused, 5);
  }
};

TEST_F(BagInput, BadInputIsOneLineAndStatusTwo) {
  writeCut("good.bag");
  std::ofstream(file("text.bag")) << "this is no bag\n";
  std::ofstream(file("empty.bag")).flush();
  rosbag::Bag(file("nothing.bag"), rosbag::bagmode::Write).close();
  {
    const std::string bytes = bytesOf("good.bag");
    std::ofstream(file("short.bag"), std::ios::binary) << bytes.substr(0, bytes.size() - 20);
    std::ofstream(file("half.bag"), std::ios::binary) << bytes.substr(0, bytes.size() / 2);
    rosbag::Bag others(file("others.bag"), rosbag::bagmode::Write);
    lasting(others, 1);
    others.write("/clock", at(0.5), rosgraph_msgs::Clock());
    others.write("/tf", at(0.5), tf2_msgs::TFMessage());
    rosbag::Bag type(file("type.bag"), rosbag::bagmode::Write);
    type.write("/incision/cut_plane", at(0), std_msgs::String());
  }
  const std::vector<std::pair<std::vector<std::string>, std::string>> bad = {
      {{}, "no bag given"},
      {{file("good.bag")}, "no scene file given"},
      {{file("good.bag"), file("plain.yaml"), "third"}, "allowed: one bag and one scene file"},
      {{file("no_such.bag"), file("plain.yaml")}, "no such file"},
      {{folder_.string(), file("plain.yaml")}, "no such file"},
      {{file("text.bag"), file("plain.yaml")}, "not a whole bag"},
      {{file("empty.bag"), file("plain.yaml")}, "not a whole bag"},
      {{file("nothing.bag"), file("plain.yaml")}, "there is no message in it"},
      {{file("short.bag"), file("plain.yaml")}, "short.bag"},
      {{file("half.bag"), file("plain.yaml")}, "half.bag"},
      {{file("others.bag"), file("plain.yaml")}, "there: /clock, /other, /tf; looked for: /incision/cut_plane)"},
      {{file("type.bag"), file("plain.yaml")}, "allowed: incision/CutPlane"},
      {{file("good.bag"), file("plain.yaml"), "--node", "other"}, "looked for: /other/cut_plane"},
      {{file("good.bag"), file("no_such.yaml")}, "no_such.yaml"}};
  for (const auto& [arguments, said] : bad) {
    EXPECT_EQ(runBag(arguments), BatchStatus::BAD_INPUT) << said;
    EXPECT_EQ(out_.str(), "");
    EXPECT_EQ(err_.str().find('\n'), err_.str().size() - 1) << err_.str();
    EXPECT_NE(err_.str().find(said), std::string::npos) << err_.str() << said;
  }
}

TEST_F(BagInput, WithAnyByteChangedABagIsReadOrRefused) {
  writeCut("good.bag");
  expectReadOrRefused("good.bag", "plain.yaml", 53);
}

TEST_F(BagInput, FullWithAnyByteChangedABagOfAllIsReadOrRefused) {
  writeAll("good.bag");
  expectReadOrRefused("good.bag", "tools.yaml", 31);
}

TEST_F(BagInput, HelpNamesEveryOption) {
  EXPECT_EQ(runBag({"--help"}), BatchStatus::DONE);
  for (const char* option : {"--node", "--steps", "--set", "--threads", "--record", "--positions", "--snapshot",
                             "--volume", "--series", "--every", "--save", "--restore"})
    EXPECT_NE(out_.str().find(option), std::string::npos) << option;
}

}  // namespace
}  // namespace incision
