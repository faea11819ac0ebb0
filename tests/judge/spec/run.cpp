/// @file
/// The judge's own doctest: the cases run in this process, and what they find is collected here
/// instead of being printed by doctest.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "judge/spec/general_misconceptions.hpp"
#include "judge/spec/impostor.hpp"
#include "judge/spec/likeness.hpp"
#include "judge/spec/run.hpp"
#include "judge/spec/session.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

std::vector<CaseResult>* results = nullptr;
std::size_t first_number = 1;
std::size_t counted = 0;  ///< cases that doctest would run

/// What doctest saw that no demand has filed: a plain assertion, or an exception of the spec.
void file_if_nothing_else(const std::string& detail) {
  Finding finding;
  finding.detail = detail;
  Session::current().found(std::move(finding));
}

struct Collector : doctest::IReporter {
  explicit Collector(const doctest::ContextOptions&) {}

  void test_case_start(const doctest::TestCaseData& data) override {
    CaseResult result;
    result.number = first_number + results->size();
    result.law = data.m_name;
    Session::current().start_case(result.number);
    results->push_back(std::move(result));
  }
  void log_assert(const doctest::AssertData& data) override {
    if (data.m_threw)
      Session::current().unusable(data.m_exception.c_str());
    else if (data.m_failed)
      file_if_nothing_else(std::string("this does not hold: ") + data.m_expr);
  }
  void test_case_exception(const doctest::TestCaseException& exception) override {
    Session::current().unusable(exception.error_string.c_str());
  }
  void test_case_end(const doctest::CurrentTestCaseStats& stats) override {
    // A case that asserts nothing proves nothing.
    if (stats.numAssertsCurrentTest == 0)
      file_if_nothing_else("this case of the spec asserts nothing");
    results->back().finding = Session::current().take_finding();
  }

  void report_query(const doctest::QueryData& data) override {
    counted = data.run_stats->numTestCasesPassingFilters;
  }
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats&) override {}
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_message(const doctest::MessageData&) override {}
  void test_case_skipped(const doctest::TestCaseData&) override {}
};

}  // namespace

DOCTEST_REGISTER_REPORTER("collector", 0, Collector);

namespace {

/// Of the cases of a unit alone, told to the collector.
void choose_cases_of(const std::string& unit, doctest::Context& context) {
  context.setOption("reporters", "collector");
  context.setOption("order-by", "file");
  context.addFilter("test-suite", unit.c_str());
}

/// Runs the cases that are wanted in `session`.
std::vector<CaseResult> run_cases(const SpecRun& run, const Session& session) {
  std::vector<CaseResult> collected;
  results = &collected;
  first_number = run.only_case > 0 ? run.only_case : 1;
  doctest::Context context;
  choose_cases_of(run.unit, context);
  if (run.only_case > 0) {
    context.setOption("first", static_cast<int>(run.only_case));
    context.setOption("last", static_cast<int>(run.only_case));
  }
  context.run();
  results = nullptr;
  session.rethrow_judge_failure();
  require(!collected.empty(), "the spec of ", run.unit, " has no test case",
          run.only_case > 0 ? " number " + std::to_string(run.only_case) : std::string());
  return collected;
}

/// Whether a value has a real number in it.
bool contains_number(const Value& value) {
  if (value.as<double>()) return true;
  const List* list = value.as<List>();
  return list && std::any_of(list->begin(), list->end(), contains_number);
}

/// Which misconceptions explain the answers of a whole run. Each one was found where a case failed,
/// from the questions until then; what came later may speak against it.
class Explanations {
 public:
  Explanations(const SpecRun& run, const std::vector<CaseResult>& cases, const Session& session)
      : run_(run), cases_(cases), session_(session) {}

  /// Whether misconception `name` fails this case too, and does not contradict the other ones.
  bool explains(const std::string& name, std::size_t case_number) {
    const auto known = verdicts_.find(name);
    const Verdict& verdict = known != verdicts_.end()
                                 ? known->second
                                 : verdicts_.emplace(name, tried(name)).first->second;
    return verdict.holds && verdict.failed.contains(case_number);
  }

 private:
  struct Verdict {
    std::set<std::size_t> failed;  ///< the cases that the misconception fails
    bool holds = false;
  };

  Verdict tried(const std::string& name) const {
    const std::vector<Misconception>& all = misconceptions_of(run_.unit);
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Misconception& each) { return each.name == name; });
    const auto k = static_cast<std::size_t>(found - all.begin());
    Impostor impostor(k);
    const Session of_misconception(run_.unit, impostor, run_.seed);
    Verdict verdict;
    for (const CaseResult& each : run_cases(run_, of_misconception))
      if (!each.passed()) verdict.failed.insert(each.number);
    verdict.holds = agrees(k, verdict.failed);
    return verdict;
  }

  /// Not if a case passed that the misconception fails, nor if most wrong answers are other ones
  /// than its own. (Some may be: a file can have two mistakes.) Yes or no is soon the same by
  /// chance: there all of them have to be its own, or a dozen more, not all the same, that were
  /// asked at once.
  bool agrees(std::size_t k, const std::set<std::size_t>& failed) const {
    int same = 0, other = 0;
    bool has_numbers = true, is_chance = true;
    for (const CaseResult& each : cases_) {
      if (each.passed() && failed.contains(each.number)) return false;
      if (each.passed() || each.finding->outcome != Outcome::wrong) continue;
      const bool is_its_own = session_.gives_the_same_in_case(each.number, k);
      ++(is_its_own ? same : other);
      if (is_its_own && session_.asked_behind_the_wrong_answer(each.number) >= 12)
        is_chance = false;
      has_numbers = has_numbers && each.finding->answer && contains_number(*each.finding->answer);
    }
    return has_numbers ? same >= other : other == 0 || !is_chance;
  }

  const SpecRun& run_;
  const std::vector<CaseResult>& cases_;
  const Session& session_;
  std::map<std::string, Verdict> verdicts_;
};

/// Whether asking once more may tell why: a question that takes its whole time is not asked again.
bool is_told_by_answers(const Finding& finding) {
  return (finding.outcome == Outcome::wrong && finding.answer) ||
         finding.outcome == Outcome::crashed || finding.outcome == Outcome::threw;
}

Misconception something_kept() {
  return {"something kept between calls",
          "Asked the same by itself, your function does otherwise. Something stays from one call "
          "to the next: a static or a global variable, or memory that is not yours or was never "
          "set.",
          ""};
}

/// The names that the numbers of a wrong answer show. What the answers before it in its case speak
/// against is none of them.
std::vector<Misconception> names_of_numbers(const CaseResult& result, const Session& session) {
  // By convention the first case of a spec asks with inputs of every kind.
  std::vector<Misconception> names = general_misconceptions(
      *result.finding, result.number == 1 ? Inputs::general : Inputs::special);
  const auto before = session.asked_before_the_wrong_answer(result.number);
  const bool may_be = std::all_of(before.begin(), before.end(), [](const Call& call) {
    return equals_argument(call.arguments, call.answer);
  });
  if (!may_be)
    std::erase_if(names,
                  [](const Misconception& each) { return each.name == argument_as_it_came; });
  return names;
}

}  // namespace

std::size_t count_cases(const std::string& unit) {
  doctest::Context context;
  choose_cases_of(unit, context);
  const std::array<const char*, 2> arguments{"judge", "--count"};  // setOption knows no flags
  context.applyCommandLine(static_cast<int>(arguments.size()), arguments.data());
  counted = 0;
  context.run();
  return counted;
}

std::vector<CaseResult> run_spec(const SpecRun& run, Answerer& answerer) {
  Session session(run.unit, answerer, run.seed);
  std::vector<CaseResult> cases = run_cases(run, session);
  Explanations explanations(run, cases, session);
  bool asked_alone = false;
  for (CaseResult& each : cases) {
    if (!each.finding) continue;
    std::vector<Misconception>& names = each.finding->misconceptions;
    std::erase_if(names, [&](const Misconception& misconception) {
      return !explanations.explains(misconception.name, each.number);
    });
    if (names.empty()) names = names_of_numbers(each, session);
    const bool has_answer = each.finding->outcome == Outcome::wrong && each.finding->answer;
    if (names.empty() && has_answer && session.answers_with_an_argument())
      names = {argument_unchanged()};
    if (names.empty() && is_told_by_answers(*each.finding) && !std::exchange(asked_alone, true) &&
        session.answers_otherwise_alone(each.number, each.finding->answer))
      names = {something_kept()};
  }
  return cases;
}

}  // namespace tumble::judge
