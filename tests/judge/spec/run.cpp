/// @file
/// The judge's own doctest: the cases run in this process, and what they find is collected here
/// instead of being printed by doctest.
#include <doctest/doctest.h>

#include <algorithm>

#include "judge/spec/general_misconceptions.hpp"
#include "judge/spec/impostor.hpp"
#include "judge/spec/run.hpp"
#include "judge/spec/session.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

std::vector<CaseResult>* results = nullptr;
std::size_t first_number = 1;

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

  void report_query(const doctest::QueryData&) override {}
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

std::vector<CaseResult> run_cases(const SpecRun& run, Answerer& answerer) {
  std::vector<CaseResult> collected;
  results = &collected;
  first_number = run.only_case > 0 ? run.only_case : 1;
  Session session(run.unit, answerer, run.seed);
  doctest::Context context;
  context.setOption("reporters", "collector");
  context.setOption("order-by", "file");
  context.addFilter("test-suite", run.unit.c_str());
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

/// Whether misconception `name` fails this case too: only then does it explain why an answer does.
bool fails_too(const SpecRun& run, std::size_t case_number, const std::string& name) {
  const std::vector<Misconception>& all = misconceptions_of(run.unit);
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Misconception& each) { return each.name == name; });
  Impostor impostor(static_cast<std::size_t>(found - all.begin()));
  const std::vector<CaseResult> again = run_cases({run.unit, run.seed, case_number}, impostor);
  return !again.front().passed();
}

}  // namespace

std::vector<CaseResult> run_spec(const SpecRun& run, Answerer& answerer) {
  std::vector<CaseResult> cases = run_cases(run, answerer);
  for (CaseResult& each : cases) {
    if (!each.finding) continue;
    std::vector<Misconception>& names = each.finding->misconceptions;
    std::erase_if(names, [&](const Misconception& misconception) {
      return !fails_too(run, each.number, misconception.name);
    });
    // By convention the first case of a spec asks with inputs of every kind.
    if (names.empty())
      names = general_misconceptions(*each.finding,
                                     each.number == 1 ? Inputs::general : Inputs::special);
  }
  return cases;
}

}  // namespace tumble::judge
