/// @file
/// What is said of a function that is right when it is called first, and keeps something.
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "judge/spec/run.hpp"
#include "judge/spec/student.hpp"

using namespace tumble::judge;

namespace {

constexpr const char* doubling = "tests/doubling";
using Numbers = std::vector<double>;
using Twice = Numbers(const Numbers& x);

/// The case is a test of this program, too: there it asks nothing.
bool is_doubling_judged = false;

Numbers twice(Numbers x) {
  for (double& each : x) each *= 2;
  return x;
}

/// "static int n = 0; if (n++ > 0) return x;", or "return x;" alone.
class ReturnsItsArgument : public Answerer {
 public:
  explicit ReturnsItsArgument(bool first_is_right) : first_is_right_(first_is_right) {}
  void start_case() override { asked_ = 0; }
  Value ask(const Call& question, const CallBack&) override {
    const bool is_right = first_is_right_ && asked_++ == 0;
    return is_right ? to_value(twice(from_value<Numbers>(question.arguments[0])))
                    : question.arguments[0];
  }
  std::string printed() override { return {}; }

 private:
  bool first_is_right_;
  int asked_ = 0;
};

enum Named { no_name, something_kept, as_it_came, another };

/// In a process of its own: doctest does not run inside of a test.
int name_given(bool first_is_right) {
  const pid_t child = fork();
  if (child == 0) {
    is_doubling_judged = true;
    ReturnsItsArgument student(first_is_right);
    const std::vector<CaseResult> cases = run_spec({doubling, 1, 0}, student);
    const auto& names = cases.at(0).finding.value().misconceptions;
    const std::string name = names.empty() ? "" : names.front().name;
    _exit(name.empty()                             ? no_name
          : name == "something kept between calls" ? something_kept
          : name == "the argument as it came"      ? as_it_came
                                                   : another);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE(WIFEXITED(status));
  return WEXITSTATUS(status);
}

}  // namespace

TEST_SUITE("tests/doubling") {
  TEST_CASE("twice as much") {
    if (!is_doubling_judged) return;
    const Function<Twice> function(doubling);
    for (const Numbers& x : {Numbers{1}, Numbers{3, 4}, Numbers{5, 6}})
      REQUIRE(function(x) == close_to(twice(x), 0));
  }
}

TEST_CASE("what was right once, and then is the argument as it came, keeps something") {
  CHECK(name_given(true) == something_kept);  // right of one number, then two as they came
  CHECK(name_given(false) != something_kept);
}
