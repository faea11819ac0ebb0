/// @file
/// Verdicts in the words of each platform, held against what it demands.
#include "judge/platforms/results.hpp"

#include <doctest/doctest.h>

#include "project/harness/refusal.hpp"
#include "project/judge/platforms/files.hpp"
#include "project/judge/platforms/schemas.hpp"

using namespace tumble::judge;
using nlohmann::json;
using tumble::test::contains;

namespace {

Course small_course() {
  Course course;
  course.units = {{"4.1", "04_quaternions", "product", "", {}, {}},
                  {"4.2", "04_quaternions", "inverse", "", {}, {}},
                  {"4.3", "04_quaternions", "rotate", "", {}, {}}};
  return course;
}

CourseSettings settings() {
  CourseSettings settings = default_settings(small_course());
  settings.credit = Credit::laws;
  settings.hidden = {"04_quaternions/inverse"};
  settings.weights["04_quaternions/product"] = 2.5;
  return settings;
}

UnitRecord verdict(const std::string& number, const std::string& unit, std::size_t hold) {
  UnitRecord record;
  record.unit = unit, record.number = number, record.laws = 3, record.laws_that_hold = hold;
  record.passed = hold == 3;
  record.summary = record.passed ? "passed" : "wrong";
  record.explanation = "why | <b>" + number + "</b>\nand how";
  if (!record.passed) {
    CaseRecord failed;
    failed.outcome = "wrong", failed.misconceptions = {"factors swapped"};
    record.cases = {failed};
  }
  return record;
}

const UnitRecord product = verdict("4.1", "04_quaternions/product", 3);
const UnitRecord inverse = verdict("4.2", "04_quaternions/inverse", 1);
const StudentRecord some{"ann", 1, 0, "", {product, inverse}};  // 4.3 is not judged yet
const StudentRecord refused{"eve", 1, 0, "has a link in it", {}};
const std::string figure = "<svg>ab</svg>";
const std::string figure_url = "data:image/svg+xml;base64,PHN2Zz5hYjwvc3ZnPg==";

}  // namespace

TEST_CASE("Gradescope: points, what is hidden until the due date, and units not judged yet") {
  const json j = json::parse(gradescope_results(settings(), some, ""));
  tumble::test::check_gradescope(j);
  REQUIRE(j.at("tests").size() == 3);
  CHECK(j.at("tests")[0].at("score") == 2.5);
  CHECK(j.at("tests")[0].at("status") == "passed");
  CHECK(j.at("tests")[1].at("score").get<double>() == doctest::Approx(1.0 / 3));
  CHECK(j.at("tests")[1].at("visibility") == "after_due_date");
  CHECK(j.at("tests")[1].at("extra_data").at("misconceptions") == json{"factors swapped"});
  CHECK(j.at("tests")[2].at("output") == "Not judged yet.");
  CHECK_FALSE(j.contains("output"));

  const json with_figure = json::parse(gradescope_results(settings(), some, figure));
  tumble::test::check_gradescope(with_figure);
  CHECK(with_figure.at("output_format") == "html");
  CHECK(contains(with_figure.at("output"), "<img src=\"" + figure_url + "\""));

  const json none = json::parse(gradescope_results(settings(), refused, ""));
  tumble::test::check_gradescope(none);
  CHECK(none.at("output") == "The submission has a link in it.");
  for (const json& test : none.at("tests")) CHECK(test.at("score") == 0);
}

TEST_CASE("PrairieLearn: a share, hidden words, and no attempt lost by what cannot be read") {
  const std::string text = prairielearn_results(settings(), some, figure);
  tumble::test::check_prairielearn(text);
  const json j = json::parse(text);
  CHECK(j.at("score").get<double>() == doctest::Approx((2.5 + 1.0 / 3) / 4.5));
  CHECK(contains(j.at("tests")[0].at("output"), "why"));
  CHECK(j.at("tests")[1].at("output") == "");
  CHECK(j.at("images")[0].at("url") == figure_url);

  StudentRecord typo = some;
  typo.units[1].summary = "does not compile";  // a hidden one too
  const json invalid = json::parse(prairielearn_results(settings(), typo, ""));
  CHECK(invalid.at("gradable") == false);
  CHECK(invalid.at("format_errors") == json{"4.2: does not compile"});
  CHECK(contains(invalid.at("output"), "why"));

  const std::string none = prairielearn_results(settings(), refused, "");
  tumble::test::check_prairielearn(none);
  CHECK(json::parse(none).at("gradable") == false);
  CHECK(json::parse(none).at("format_errors")[0] == "The submission has a link in it.");
}

TEST_CASE("a judge that failed says so above all, and no platform takes it for a zero") {
  StudentRecord failed = some;
  failed.units[1].judge_failure = "the memory is used up";
  failed.units[1].summary = "judge failed";
  const json gradescope = json::parse(gradescope_results(settings(), failed, ""));
  tumble::test::check_gradescope(gradescope);
  CHECK(contains(gradescope.at("output"), "The judge failed at 4.2: these points are not"));
  CHECK(contains(json::parse(gradescope_results(settings(), failed, figure)).at("output"),
                 "<p>The judge failed at 4.2"));
  CHECK(json::parse(prairielearn_results(settings(), failed, "")).at("gradable") == false);
}

TEST_CASE("PrairieLearn: extra points make no more than all") {
  CourseSettings bonus = settings();
  bonus.rules.extra = {"04_quaternions/product"};
  const StudentRecord all{"ann",
                          1,
                          0,
                          "",
                          {product, verdict("4.2", "04_quaternions/inverse", 3),
                           verdict("4.3", "04_quaternions/rotate", 3)}};
  const std::string text = prairielearn_results(bonus, all, "");
  tumble::test::check_prairielearn(text);
  CHECK(json::parse(text).at("score") == 1);
}

TEST_CASE("Classroom 50: whole points, a hundred to one, and who is meant") {
  std::map<std::string, std::string> environment{
      {"CLASSROOM", "dynamics"},    {"ASSIGNMENT", "hw4"},
      {"ASSIGNMENT_TYPE", "group"}, {"OWNER", "ann"},
      {"COMMIT_URL", "https://c"},  {"SUBMISSION_TAG", "submit/20261201T000000Z-abc"},
      {"RELEASE_URL", "https://r"}, {"REVIEW_URL", "https://v"}};
  const json j = json::parse(classroom50_result(settings(), some, environment));
  tumble::test::check_classroom50(j);
  CHECK(j.at("score") == 250 + 33);
  CHECK(j.at("max-score") == 450);
  CHECK(j.at("tests")[1].at("output") == "");
  environment.erase("OWNER");
  CHECK_REFUSED(classroom50_result(settings(), some, environment), "the environment lacks OWNER");
}

TEST_CASE("what no time was left for says so, on every platform") {
  StudentRecord late = some;
  late.out_of_time = true;
  const json gradescope = json::parse(gradescope_results(settings(), late, ""));
  CHECK(gradescope.at("tests")[2].at("output") == "Not judged: no time left.");
  const json learn = json::parse(prairielearn_results(settings(), late, ""));
  CHECK(learn.at("tests")[2].at("output") == "Not judged: no time left.");
  CHECK(contains(markdown_results(settings(), late),
                 "| 4.3 rotate | not judged: no time left | 0.00 of 1.00 |\n"));
}

TEST_CASE("Markdown: a table, and words that stay words") {
  const std::string text = markdown_results(settings(), some);
  CHECK(contains(text, "### tumble: 2.83 of 4.50 points\n"));
  CHECK(contains(text, "| 4.1 product | passed | 2.50 of 2.50 |\n"));
  CHECK(contains(text, "| 4.3 rotate | not judged yet | 0.00 of 1.00 |\n"));
  CHECK_FALSE(contains(text, "<b>4.2"));  // hidden
  CourseSettings open = settings();
  open.hidden.clear();
  CHECK(contains(markdown_results(open, some), "\n    why | <b>4.2</b>\n    and how\n"));
  CHECK(contains(markdown_results(settings(), refused), "The submission has a link in it."));
}
