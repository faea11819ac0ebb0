/// @file
/// When a case names a wrong yes or no: two of them are soon the same by chance, a dozen are not.
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <utility>
#include <vector>

#include "judge/spec/run.hpp"
#include "judge/spec/student.hpp"

using namespace tumble::judge;

namespace {

constexpr const char* yes_or_no = "tests/is_large";
using IsLarge = bool(int x);

bool is_large(int x) { return x >= 100; }

/// What the spec asks in its first case, all at once. Its cases are tests of this program, too:
/// there they ask nothing.
std::vector<int> asked_at_once;
bool is_judged = false;

const Misconceptions<IsLarge> yes_for_no{
    yes_or_no, {{"yes for no", "You say yes for no.", "", [](int x) { return !is_large(x); }}}};

/// Says yes for no in the first case, and in the second is right of 1000 alone.
class SaysYesForNo : public Answerer {
 public:
  void start_case() override { ++case_; }
  Value ask(const Call& question, const CallBack&) override {
    const int x = from_value<int>(question.arguments[0]);
    return to_value(case_ == 1 ? !is_large(x) : x == 1000);
  }
  std::string printed() override { return {}; }

 private:
  int case_ = 0;
};

/// How many names the first case gets where it asks for these. In a process of its own: doctest
/// does not run inside of a test.
int count_names(std::vector<int> asked) {
  const pid_t child = fork();
  if (child == 0) {
    asked_at_once = std::move(asked);
    is_judged = true;
    SaysYesForNo student;
    const std::vector<CaseResult> cases = run_spec({yes_or_no, 1, 0}, student);
    const bool is_second_named = !cases.at(1).finding.value().misconceptions.empty();
    _exit(is_second_named ? 100
                          : static_cast<int>(cases.at(0).finding.value().misconceptions.size()));
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WIFEXITED(status));
  return WEXITSTATUS(status);
}

}  // namespace

TEST_SUITE("tests/is_large") {
  TEST_CASE("all at once") {
    if (!is_judged) return;
    const Function<IsLarge> function(yes_or_no);
    std::vector<std::pair<Answer<bool>, bool>> answers;
    for (const int x : asked_at_once) answers.emplace_back(function(x), is_large(x));
    for (const auto& [answer, right] : answers) REQUIRE(answer == close_to(right, 0));
  }

  TEST_CASE("one by one") {
    if (!is_judged) return;
    const Function<IsLarge> function(yes_or_no);
    for (const int x : {1000, 500, 20}) REQUIRE(function(x) == close_to(is_large(x), 0));
  }
}

TEST_CASE("yes or no: a dozen answers behind the first wrong one name it, if they differ") {
  std::vector<int> asked = {1, 2, 3, 4, 5, 6, 200, 201, 202, 203, 204, 205};
  CHECK(count_names(asked) == 0);
  asked.push_back(206);
  CHECK(count_names(asked) == 1);
  CHECK(count_names(std::vector<int>(40, 7)) == 0);
}
