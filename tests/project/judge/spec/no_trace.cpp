/// @file
/// Answers that equal others by accident: an argument unchanged, and who evaluates what.
#include <doctest/doctest.h>

#include <functional>
#include <string>
#include <vector>

#include "judge/spec/student.hpp"

using namespace tumble::judge;

namespace {

using Rate = std::function<double(double)>;
using Step = double(const Rate&, double);

/// Two slopes that count for nothing, and two that count for x.
const Misconceptions<Step> to_nowhere{
    "tests/to_nowhere",
    {{"no step", "", "", [](const Rate& f, double x) { return x + 0 * (f(x) + f(x)); }}}};
const Misconceptions<Step> twice_as_far{
    "tests/twice_as_far",
    {{"twice", "", "", [](const Rate& f, double x) { return 2 * x + 0 * (f(x) + f(x)); }}}};

/// Evaluates the function so many times, and answers with a multiple of x.
class Student : public Answerer {
 public:
  Student(int times, double factor) : times_(times), factor_(factor) {}
  void start_case() override {}
  Value ask(const Call& question, const CallBack& call_back) override {
    for (int n = 0; n < times_; ++n) call_back(FunctionId{0}, {question.arguments[1]});
    return factor_ * *question.arguments[1].as<double>();
  }
  std::string printed() override { return {}; }

 private:
  int times_;
  double factor_;
};

/// Whether the unit's misconception is the name of this student's answer.
bool is_named(const char* unit, int times, double factor) {
  Student student(times, factor);
  Session session(unit, student, 1);
  session.start_case(1);
  const auto answer = Function<Step>(unit)([](double x) { return x; }, 3.);
  CHECK_FALSE(answer == close_to(0., 0));
  return !session.take_finding().value().misconceptions.empty();
}

/// Whether so many answers to different questions are known to be an argument.
bool is_an_argument(int answers, double factor) {
  Student student(0, factor);
  Session session("tests/to_nowhere", student, 1);
  session.start_case(1);
  for (int n = 1; n <= answers; ++n)
    Function<Step>("tests/to_nowhere")([](double x) { return x; }, n);
  return session.answers_with_an_argument();
}

}  // namespace

TEST_CASE("an argument unchanged is a misconception's number only after as many evaluations") {
  CHECK_FALSE(is_named("tests/to_nowhere", 0, 1));
  CHECK_FALSE(is_named("tests/to_nowhere", 1, 1));
  CHECK(is_named("tests/to_nowhere", 2, 1));
}

TEST_CASE("other numbers are, unless one evaluates and the other does not") {
  CHECK_FALSE(is_named("tests/twice_as_far", 0, 2));
  CHECK(is_named("tests/twice_as_far", 1, 2));
  CHECK(is_named("tests/twice_as_far", 7, 2));
}

TEST_CASE("a number is an argument unchanged if several answers of a run say so") {
  CHECK_FALSE(is_an_argument(1, 1));
  CHECK(is_an_argument(4, 1));
  CHECK_FALSE(is_an_argument(4, 2));
}
