// A fixed sample of the random scenes of `./tumble bench dynamics --only honesty`: what simulate()
// says of its error is no more than ten times too little, and what it says it reached, it has.
#include <doctest/doctest.h>

#include "project/harness/honesty_table.hpp"
#include "project/harness/sanitized.hpp"

using namespace tumble;

TEST_CASE("random scenes: nothing is silently wrong") {
  constexpr std::uint64_t scenes = test::tries(160, 5);
  std::vector<test::Answer> answers;
  for (std::uint64_t seed = 5000; seed < 5000 + scenes; ++seed) {
    CAPTURE(seed);
    const auto answer = test::answer_for(test::motion_scene(seed));
    if (!answer) continue;
    INFO("asked ", answer->asked, ", stated ", answer->stated, ", true ", answer->truth);
    if (answer->refused.empty()) CHECK(answer->per_stated() <= 10);
    answers.push_back(*answer);
  }
  INFO(test::honesty_table(answers).text());
  CHECK(answers.size() >= 0.85 * scenes);
  CHECK(test::per_asked(answers).part(0.99) <= 1);
  CHECK(test::per_asked(answers).size() >= 0.8 * static_cast<double>(answers.size()));
}

// Near rounding two runs have been ten times closer to each other than to the truth, and more.
TEST_CASE("random scenes: luck is not taken for accuracy") {
  for (const std::uint64_t seed : {859U, 1566U, 1787U, 1869U}) {
    CAPTURE(seed);
    const auto answer = test::answer_for(test::motion_scene(seed));
    REQUIRE(answer);
    CHECK(answer->per_stated() <= 10);
  }
}
