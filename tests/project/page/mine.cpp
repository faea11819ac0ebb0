/// @file
/// Figures that ask a reader's own functions, in a browser: an engine of files that pass, and of
/// solutions for what they lack.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "09_rigid_body/handle_motion.hpp"
#include "project/page/page_judge.hpp"
#include "support/scene_for_reader.hpp"

using namespace tumble;
using namespace tumble::test;
using rigid_body_chapter::handle_figure::the_handle;
using Json = nlohmann::ordered_json;

namespace {

/// Whether all chapters are there: an engine needs them.
bool can_ask_engine() {
  if (!can_judge_in_page()) return false;
  const Json manifest =
      Json::parse(support::read_text(from_environment("TUMBLE_EXERCISES") + "/manifest.json"));
  return manifest.at("engine") == true || (skip("only some chapters are in the page"), false);
}

Json numbers(const std::vector<double>& all) { return all; }

/// The handle's first second, by 1000 steps: the states at its start and its end.
std::vector<double> handle_question(const RigidBodyState<>& start) {
  std::vector<double> question = support::scene_for_reader(the_handle().body, start, 1);
  question.insert(question.end(), {1000, 1});
  return question;
}

Written solution_of(const std::string& unit) {
  return {unit, "solution",
          support::read_text(from_environment("TUMBLE_ROOT") + "/solutions/" + unit + ".cpp")};
}

/// A function that moves nothing: not what passes, so one sees whose it is.
Written simulate_that_stands_still() {
  return {"09_rigid_body/simulate", "stands still",
          "namespace rigid_body {\n"
          "std::vector<State> simulate(const Body&, const WrenchAt&, const State& start, double,\n"
          "                            double, int steps) {\n"
          "  return std::vector<State>(static_cast<std::size_t>(steps) + 1, start);\n"
          "}\n"
          "}  // namespace rigid_body\n"};
}

}  // namespace

TEST_CASE("a figure's engine of solutions moves the handle as the library does") {
  if (!can_ask_engine()) return;
  PageJudge page;
  const RigidBodyState<> start = rigid_body_chapter::handle_figure::start_of(0.01);
  const Json answer = page.answer_to_figure("motion", numbers(handle_question(start)), {});
  REQUIRE(answer.contains("numbers"));
  CHECK(answer.at("own").empty());
  const auto all = answer.at("numbers").get<std::vector<double>>();
  const std::vector<RigidBodyState<>> states = support::states_from_reader(all);
  REQUIRE(states.size() == 2);
  const Quat end = FreeTrajectory(the_handle().body, start).at(1).q;
  // A method of order 4 that turns by ω h a step, over ω t, and the roundings of its steps.
  constexpr double omega = 2 * rigid_body_chapter::handle_figure::pi, steps = 1000;
  CHECK(angle_between(states[1].q, end) < omega * std::pow(omega / steps, 4));
  CHECK((states[1].L - start.L).norm() <=
        steps * std::numeric_limits<double>::epsilon() * start.L.norm());
}

TEST_CASE("a figure's engine takes the reader's file where there is one") {
  if (!can_ask_engine()) return;
  PageJudge page;
  const RigidBodyState<> start = rigid_body_chapter::handle_figure::start_of(0.01);
  const Json answer =
      page.answer_to_figure("motion", numbers(handle_question(start)),
                            {simulate_that_stands_still(), solution_of("04_quaternions/slerp")});
  REQUIRE(answer.contains("numbers"));
  CHECK(answer.at("own") == Json{"09_rigid_body/simulate"});  // it needs no slerp
  const auto all = answer.at("numbers").get<std::vector<double>>();
  REQUIRE(all.size() == 26);
  CHECK(std::equal(all.begin(), all.begin() + 13, all.begin() + 13));
}

TEST_CASE("a figure's engine: the cost of runs, and an impact") {
  if (!can_ask_engine()) return;
  PageJudge page;
  std::vector<double> question = support::scene_for_reader(
      the_handle().body, rigid_body_chapter::handle_figure::start_of(0.01), 1);
  question.insert(question.end(), {10, 20});
  const Json runs =
      page.answer_to_figure("work", numbers(question), {solution_of("09_rigid_body/simulate")});
  REQUIRE(runs.contains("numbers"));
  CHECK(runs.at("numbers").size() == 10);
  CHECK(runs.at("numbers").at(5) == 2 * runs.at("numbers").at(0).get<double>());
  CHECK(runs.at("own") == Json{"09_rigid_body/simulate"});
  // A ball of 1 kg that falls straight: only the normal impulse.
  const Json impact = page.answer_to_figure("impact", Json{1, 0, 0, 1, 0, -2, 0.5, 0.3}, {});
  CHECK(impact.at("numbers") == Json{0, 3});
}

TEST_CASE("a figure's engine: a die on a table") {
  if (!can_ask_engine()) return;
  PageJudge page;
  // A cube of 1 kg and 0.1 m on its face, 5 m up. Its lower corners hit one after the other.
  const Json question{1, 0.1, 10, 0.5, 1e-9, 0, 0, 0, 5.05, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 4};
  const Json answer =
      page.answer_to_figure("die", question, {solution_of("11_when_bodies_meet/collide")});
  REQUIRE(answer.contains("numbers"));
  CHECK(answer.at("own") == Json{"11_when_bodies_meet/collide"});
  const auto all = answer.at("numbers").get<std::vector<double>>();
  REQUIRE(all.size() == 4 * 14);
  // It lands after 1 s with 10 m/s, and touches up to 1e-9 m earlier.
  CHECK(all[0] <= 1);
  CHECK(all[0] >= 1 - 2e-10);
}

TEST_CASE("a figure's engine: an endless loop, a file that does not compile") {
  if (!can_ask_engine()) return;
  PageJudge page;
  const Json question = numbers(handle_question(rigid_body_chapter::handle_figure::start_of(0.01)));
  Written endless = simulate_that_stands_still();
  endless.text.insert(endless.text.find("  return"), "  for (;;) {\n  }\n");
  CHECK(page.answer_to_figure("motion", question, {endless}).at("outcome") == "hung");
  const Json answer =
      page.answer_to_figure("motion", question, {{"09_rigid_body/simulate", "broken", "int x ="}});
  CHECK(answer.contains("numbers"));
  CHECK(answer.at("own").empty());
}
