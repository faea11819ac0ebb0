/// @file
/// How often an answer may evaluate the functions among its arguments.
#include <doctest/doctest.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "judge/spec/student.hpp"

using namespace tumble::judge;

namespace {

using Numbers = std::vector<double>;
using Asked = Function<double(const std::function<double(Numbers)>&, const Numbers&)>;

constexpr const char* evaluating = "tests/evaluations";

/// Evaluates the function that it is given again and again, at a place of a hundred numbers.
class EvaluatesAgain : public Answerer {
 public:
  int times = 0;

  void start_case() override {}
  Value ask(const Call& question, const CallBack& call_back) override {
    const List place = {question.arguments[1]};
    for (int n = 0; n < times; ++n) call_back(FunctionId{0}, place);
    return 1.;
  }
  std::string printed() override { return {}; }
};

/// How the case ends in which `function` is asked once.
std::optional<Finding> ending_of(Session& session, std::size_t number, const Asked& function) {
  session.start_case(number);
  try {
    static_cast<void>(function([](const Numbers& x) { return x[0]; }, Numbers(100, 1.)));
  } catch (const NoAnswer&) {
  }
  return session.take_finding();
}

}  // namespace

TEST_CASE("evaluations: as often as a spec allows, and not once more") {
  EvaluatesAgain student;
  const Session session(evaluating, student, 1);
  const Asked function(evaluating, 10);
  student.times = 10;
  CHECK_FALSE(ending_of(Session::current(), 1, function));
  student.times = 11;
  const std::optional<Finding> finding = ending_of(Session::current(), 2, function);
  REQUIRE(finding);
  CHECK(finding->outcome == Outcome::wrong_call);
  CHECK(finding->detail.starts_with("10 times for one answer"));
  CHECK(finding->question->evaluations == 10);
  CHECK(finding->question->first_evaluations.size() == 4);
}

TEST_CASE("evaluations: a cheap loop spoils no other case, and two dear ones are enough") {
  EvaluatesAgain student;
  const Session session(evaluating, student, 1);
  student.times = 1'000'000;
  for (std::size_t number = 1; number <= 5; ++number) {
    const std::optional<Finding> finding =
        ending_of(Session::current(), number, Asked(evaluating, 1000));
    REQUIRE(finding);
    CHECK(finding->outcome == Outcome::wrong_call);
  }
  // What the first of these two was told is not kept: there is room for the second.
  for (std::size_t number = 6; number <= 7; ++number) {
    const std::optional<Finding> finding = ending_of(Session::current(), number, Asked(evaluating));
    REQUIRE(finding);
    CHECK(finding->detail.starts_with("20000 times for one answer"));
  }
  const std::optional<Finding> finding = ending_of(Session::current(), 8, Asked(evaluating));
  REQUIRE(finding);
  CHECK(finding->outcome == Outcome::not_run);
}
