/// @file
/// Every submission in tests/project/attacks/, judged in a browser: no law is unearned, nothing
/// hangs, and the next file is judged as if nothing had been. Which words end an attack differs
/// from the native judge's where the system does (tests/judge/page/README.md).
#include <doctest/doctest.h>

#include <cstdio>

#include "project/judge/attacks/submission.hpp"
#include "project/page/page_judge.hpp"

using namespace tumble::test;
using Json = nlohmann::ordered_json;

namespace {

const std::string unit = "04_quaternions/product";

Written product(const std::string& name, const std::string& text) { return {unit, name, text}; }

std::vector<std::string> words_of(const std::string& list) {
  std::istringstream in(list);
  std::vector<std::string> words;
  for (std::string word; std::getline(in, word, ',');) words.push_back(word);
  return words;
}

/// Those with one of the words of TUMBLE_PAGE_ATTACKS in their names ("loop,exit"), or all.
std::vector<Submission> chosen(const std::string& folder) {
  std::vector<Submission> all = submissions_in(root() / folder);
  const std::vector<std::string> words = words_of(from_environment("TUMBLE_PAGE_ATTACKS"));
  if (words.empty()) return all;
  std::erase_if(all, [&](const Submission& attack) {
    return std::none_of(words.begin(), words.end(), [&](const std::string& word) {
      return attack.name.find(word) != std::string::npos;
    });
  });
  return all;
}

/// A table for those who look at what the judge says: TUMBLE_ATTACKS_VERBOSE=1.
void show(const Submission& attack, const Json& verdict, double seconds) {
  if (from_environment("TUMBLE_ATTACKS_VERBOSE").empty()) return;
  std::string expected;
  for (const std::string& each : attack.verdicts)
    expected += (expected.empty() ? "" : " | ") + each;
  const std::string summary = verdict.value("summary", verdict.dump());
  std::printf("%-40s %-30s %-30s %5.1f s\n", attack.name.c_str(), summary.c_str(),
              expected == summary ? "" : expected.c_str(), seconds);
  std::fflush(stdout);
}

Json judged(PageJudge& page, const Submission& attack) {
  const auto began = std::chrono::steady_clock::now();
  Json verdict = page.verdict_on(product(attack.name, attack.text), usual_seed);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - began;
  show(attack, verdict, time.count());
  return verdict;
}

void check_solution_passes(PageJudge& page, const std::string& after) {
  const std::string solution = text_of(root() / "solutions" / (unit + ".cpp"));
  const Json verdict = page.verdict_on(product("solution", solution), usual_seed);
  CHECK_MESSAGE(verdict.value("summary", "") == "passed", "after ", after, ": ", verdict.dump());
}

}  // namespace

TEST_CASE("attacks: none earns a law in a page that it does not earn natively") {
  if (!can_judge_in_page()) return;
  PageJudge page;
  std::string last = "nothing";
  for (const Submission& attack : chosen("tests/project/attacks")) {
    CAPTURE(attack.name);
    const Json verdict = judged(page, attack);
    const bool may_pass = std::count(attack.verdicts.begin(), attack.verdicts.end(), "passed") != 0;
    CHECK_MESSAGE(!verdict.contains("failure"), verdict.dump());
    CHECK((may_pass || !verdict.value("passed", false)));
    CHECK(verdict.value("laws_that_hold", std::size_t{0}) <= attack.laws);
    // A verdict on cost says what was spent.
    if (verdict.value("summary", "") == "too expensive to compile")
      CHECK(verdict.value("seconds", 0.) > 0.005);
    last = attack.name;
  }
  check_solution_passes(page, last);
}

TEST_CASE("attacks: what is odd but honest passes in a page") {
  if (!can_judge_in_page()) return;
  PageJudge page;
  for (const Submission& honest : chosen("tests/project/attacks/honest")) {
    CAPTURE(honest.name);
    const Json verdict = judged(page, honest);
    CHECK_MESSAGE(verdict.value("passed", false), verdict.dump());
  }
}
