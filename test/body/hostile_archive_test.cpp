// Bytes that no body has written are refused, or make a body that can be.
#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <sstream>

#include "incision/base/input_error.h"
#include "support/broken_plate.h"
#include "support/sanitized.h"
#include "support/scenes.h"

namespace incision::test {
namespace {

// Words of the bytes are replaced by what hurts most: the greatest numbers, the least, those beside others.
TEST(HostileBytes, AreRefusedOrMakeABodyThatSteps) {
  const Scene scene = everythingAtOnce(Method::ITERATIVE);
  DeformableBody body(scene, loadMesh(scene));
  for (int k = 0; k < 12; ++k) body.step();
  const std::string bytes = bytesOf(body);
  const std::string before = bytes;
  std::mt19937 random(7);
  const std::array<std::int64_t, 8> words = {
      -1, 0, 1, 1 << 30, std::int64_t{1} << 40, -(1 << 20), 77, 0x3ff0000000000000};
  int refused = 0, taken = 0;
  for (int trial = 0; trial < (SANITIZED ? 60 : 400); ++trial) {
    std::string bad = bytes;
    const std::size_t size = trial % 2 == 0 ? 4 : 8, at = random() % (bad.size() - size);
    std::memcpy(bad.data() + at, &words[random() % words.size()], size);
    try {
      body.restore(bad);
    } catch (const InputError&) {
      ++refused;
      continue;
    }
    ++taken;
    try {
      body.step();
    } catch (const StepFailed&) {
    }
    body.restore(bytes);
  }
  EXPECT_EQ(bytesOf(body), before);
  EXPECT_GT(refused, 20);
  EXPECT_GT(taken, 1);
}

}  // namespace
}  // namespace incision::test
