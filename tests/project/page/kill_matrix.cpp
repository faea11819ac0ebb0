/// @file
/// The kill matrix of every chapter that is built for the page, from a browser and natively.
#include <doctest/doctest.h>

#include "project/page/page_judge.hpp"

using namespace tumble::test;
using Json = nlohmann::ordered_json;

TEST_CASE("kill matrix: a page fails and names every misconception, as the native judge does") {
  if (!can_judge_in_page()) return;
  PageJudge page;
  for (const std::string& digits : chapters_in_page()) {
    CAPTURE(digits);
    const Json here = page.kill_matrix(digits, usual_seed);
    const CommandResult native =
        run_command(from_environment("TUMBLE_JUDGE") + " matrix " +
                    std::to_string(std::stoi(digits)) + " --seed " + std::to_string(usual_seed));
    CHECK(here.at("complete") == true);
    CHECK(here.at("matrix") == native.output);
  }
}
