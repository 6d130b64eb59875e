// What is displayed after memory has run out in a display, wherever that is: all that there is, as if it had not.
#include <gtest/gtest.h>
#include <ros/serialization.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <functional>
#include <new>

#include "incision/ros/display.h"
#include "support/allocation_hooks.h"
#include "support/broken_plate.h"
#include "support/forceps.h"
#include "support/sanitized.h"
#include "support/scenes.h"

namespace incision::test {
namespace {

template <typename Message>
std::string bytesOf(const std::optional<Message>& message) {
  if (!message) return "none";
  std::string bytes(ros::serialization::serializationLength(*message), '\0');
  ros::serialization::OStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, *message);
  return bytes;
}

/// All that is sent of a display, by topic.
std::vector<std::string> sent(const DisplayMessages& messages) {
  std::string stress;
  if (messages.region_stress)
    for (const RegionStress& region : *messages.region_stress)
      stress += std::to_string(region.mean) + ' ' + std::to_string(region.largest) + ' ';
  return {bytesOf(messages.body),     bytesOf(messages.cloud), bytesOf(messages.obstacles),
          bytesOf(messages.contacts), bytesOf(messages.tools), stress};
}

const std::vector<std::string> TOPICS = {"markers", "surface", "obstacles", "contacts", "tool_markers", "stress"};

/// A body whose displays are disturbed.
struct Scenario {
  std::string name;
  Scene scene;
  Descriptions descriptions;
  int steps_before;
  DisplayWishes wishes;
};

/// A body and who displays it, after a first display.
class Displayed {
 public:
  explicit Displayed(const Scenario& scenario)
      : wishes_(scenario.wishes),
        body_(scenario.scene, loadMesh(scenario.scene), scenario.descriptions),
        builder_(body_),
        links_(body_.obstacles().links.size()) {
    for (std::size_t i = 0; i < links_.size(); ++i) links_[i].position.x() = 0.01 * static_cast<double>(i + 1);
    body_.wantWrenches(true);
    for (int k = 0; k < scenario.steps_before; ++k) step_ = body_.step();
    display();
    EXPECT_EQ(body_.cut(plane(body_.bounds().min + 0.4 * (body_.bounds().max - body_.bounds().min), Vec3(1, 0.2, 0.1)))
                  .status,
              CutStatus::APPLIED);
    step_ = body_.step();
  }

  DisplayMessages display() { return builder_.build(source_.take(body_, links_, step_, wishes_), ros::Time(1)); }

 private:
  const DisplayWishes wishes_;
  DeformableBody body_;
  DisplaySource source_;
  DisplayBuilder builder_;
  std::vector<Pose> links_;
  StepResult step_;
};

/// Refuses so many allocations of a display from the n-th on. Returns how many there were.
std::int64_t refuse(const Scenario& scenario, const std::vector<std::string>& whole, std::int64_t n,
                    std::int64_t count) {
  Displayed displayed(scenario);
  std::optional<DisplayMessages> messages;
  const std::int64_t refused = refusing(n, count, [&] {
    try {
      messages = displayed.display();
    } catch (const std::bad_alloc&) {
    }
  });
  EXPECT_TRUE(messages || refused > 0);
  for (int time = 0; time < 2; ++time) {
    const std::vector<std::string> found = sent(messages ? *messages : displayed.display());
    messages.reset();
    for (std::size_t i = 0; i < TOPICS.size(); ++i)
      EXPECT_TRUE(found[i] == whole[i]) << scenario.name << ", number " << n << ": " << TOPICS[i];
  }
  return refused;
}

void expectWhole(const Scenario& scenario, int every) {
  const std::vector<std::string> whole = sent(Displayed(scenario).display());
  for (std::size_t i = 0; i < TOPICS.size() && scenario.wishes.cloud; ++i)
    EXPECT_TRUE(!whole[i].empty() && whole[i] != "none") << scenario.name << ": " << TOPICS[i];
  std::int64_t n = 1;
  while (refuse(scenario, whole, n, n % 2 == 1 ? 1 : 20) > 0 && !testing::Test::HasFailure()) n += every;
  EXPECT_GT(n, 1) << scenario.name;
  std::printf("%s: %d\n", scenario.name.c_str(), static_cast<int>(n));
}

DisplayWishes all(MarkerField field) {
  DisplayWishes wishes;
  wishes.markers = wishes.cloud = wishes.contacts = wishes.obstacles = wishes.tools = wishes.region_stress = true;
  wishes.field = field;
  return wishes;
}

/// A plate of two tissues that loads pull, beside a post and in the way of a blade.
Scenario plate(MarkerField field) {
  Scene scene = everythingAtOnce(Method::ITERATIVE);
  scene.body.grid->cells = {4, 2, 1};
  scene.fracture.reset();
  RegionSettings soft;
  soft.place = Place(Vec3(-1, -1, -1), Vec3(0.5, 1, 1));
  soft.young_modulus = 2e4;
  scene.body.regions = {soft};
  scene.loads = {{Place(Vec3(0.999, -1, -1), Vec3(2, 1, 1)), Vec3(5, 0, 0), 0}};
  scene.contact->obstacles = "room.urdf";
  const std::string room =
      "<robot name='room'><link name='post'><collision><geometry><cylinder radius='0.1' "
      "length='0.4'/></geometry></collision></link></robot>";
  return {"plate " + std::to_string(static_cast<int>(field)), scene, {{""}, room}, 4, all(field)};
}

/// A slab that forceps hold.
Scenario slab() {
  Scene scene = slabAndForceps(0.5, true);
  scene.boundary = {SLAB_END};
  scene.tools[0].poses = {{0, AT_EDGE}, {0.02, AT_EDGE}, {0.06, facingX(-0.02)}};
  scene.tools[0].jaw->angles = {{0, FORCEPS_OPEN}, {0.01, 0.03}};
  return {"slab", scene, {{forcepsUrdf({})}, ""}, 4, all(MarkerField::NONE)};
}

std::vector<Scenario> scenarios() {
  std::vector<Scenario> list = {plate(MarkerField::STRESS), plate(MarkerField::REGION), slab()};
  Scenario markers = plate(MarkerField::NONE);
  markers.name = "markers alone";
  markers.wishes = DisplayWishes();
  markers.wishes.markers = true;
  list.push_back(markers);
  return list;
}

TEST(DisplayWithoutMemory, LeavesTheNextOneWhole) {
  for (const Scenario& scenario : scenarios()) expectWhole(scenario, SANITIZED ? 499 : 97);
}

TEST(FullDisplayWithoutMemory, LeavesTheNextOneWhole) {
  for (const Scenario& scenario : scenarios()) expectWhole(scenario, 1);
}

}  // namespace
}  // namespace incision::test
