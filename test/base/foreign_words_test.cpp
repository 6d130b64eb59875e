#include "incision/base/foreign_words.h"

#include <gtest/gtest.h>

#include "support/section.h"

namespace incision {
namespace {

using test::complaint;

const std::vector<std::string> SCENE = {"body", "boundary", "solver"};

TEST(ForeignWords, AKnownWordIsAnsweredWithHowItIsSaidHere) {
  EXPECT_EQ(saidHere("fixed", SCENE),
            ": nodes are held by `boundary: [{box: [[-1, -1, -1], [0.001, 1, 1]]}]` or `boundary: [{group: rib}]`");
  EXPECT_EQ(saidHere("dt", SCENE), ": the time step is `solver: {time_step: 0.01}`");
}

TEST(ForeignWords, AWordIsKnownHoweverItIsWritten) {
  const std::vector<std::string> material = {"young_modulus", "poisson_ratio"};
  const std::string answer = saidHere("young", material);
  EXPECT_FALSE(answer.empty());
  for (const char* written : {"youngModulus", "YoungsModulus", "youngs_modulus", "Young-Modulus", "E"})
    EXPECT_EQ(saidHere(written, material), answer) << written;
}

TEST(ForeignWords, AWordIsKnownInItsOwnSectionAlone) {
  EXPECT_EQ(saidHere("fixed", {"point", "normal"}), "");
  EXPECT_EQ(saidHere("dt", {"time_step"}), ": the time step in s is `solver: {time_step: 0.01}`");
  for (const char* other : {"", "_", "fixe", "fixedfixed", "bounday"}) EXPECT_EQ(saidHere(other, SCENE), "") << other;
}

TEST(ForeignWords, TheAnswerStandsInTheLineOfTheUnknownKeyAndAGuessDoesForTheRest) {
  const auto parse = [](const YamlValue& value) { return value.map(SCENE); };
  EXPECT_EQ(complaint(parse, "a", "{timestep: 1}"),
            "scene.yaml: a.timestep: unknown key: the time step is `solver: {time_step: 0.01}` (allowed: body, "
            "boundary, solver)");
  EXPECT_EQ(complaint(parse, "a", "{boundry: 1}"),
            "scene.yaml: a.boundry: unknown key, did you mean boundary? (allowed: body, boundary, solver)");
}

}  // namespace
}  // namespace incision
