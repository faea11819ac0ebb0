/// @file
/// What an instructor reads about a class.
#include "judge/class/report.hpp"

#include <doctest/doctest.h>

#include "judge/spec/misconception.hpp"

using namespace tumble::judge;

namespace {

const Unit unit{"4.1", "04_quaternions", "product", "", {}, {}};

CourseSettings settings() {
  Course course;
  course.units = {unit};
  return default_settings(course);
}

/// A student's verdict; `mistake` is that of every law that does not hold.
StudentRecord student(const std::string& name, const std::string& summary, int tries,
                      const std::string& mistake = "") {
  UnitRecord record;
  record.unit = unit.id(), record.number = unit.number, record.summary = summary;
  record.passed = summary == "passed", record.tries = tries, record.source = 17;
  for (const std::size_t i : {1u, 2u}) {
    CaseRecord each{i, "law " + std::to_string(i), summary, "", "", {}};
    if (!mistake.empty()) each.misconceptions = {mistake};
    record.cases.push_back(each);
  }
  return {name, 1, 0, "", {record}};
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("statistics: who passed, who did not, who has not begun") {
  StudentRecord absent{"eve", 1, 0, "is encrypted", {}};
  const std::vector<UnitStatistics> all = statistics_of(
      settings(), {student("a", "passed", 1), student("b", "passed", 4),
                   student("c", "wrong", 2, "swapped"), student("d", "wrong", 1, "swapped"),
                   student("e", "crashed", 1), student("f", "not implemented", 0), absent});
  REQUIRE(all.size() == 1);
  CHECK(all[0].passed == 2);
  CHECK(all[0].failed == 3);
  CHECK(all[0].not_started == 1);
  CHECK(all[0].unread == 1);  // a submission that could not be read is not one that was not made
  CHECK(all[0].mean_tries == 2.5);
  CHECK(all[0].misconceptions == Counts{{"swapped", 2}});  // once a student, not once a law
  CHECK(all[0].outcomes == Counts{{"wrong", 2}, {"crashed", 1}});
  CHECK(all[0].laws == Counts{{"law 1", 3}, {"law 2", 3}});
}

TEST_CASE("report: what to explain again, and no names unless asked") {
  misconceptions_of(unit.id()) = {{"swapped", "q p is not p q.", "The product"}};
  CourseSettings course = settings();
  course.title = "A & B <script>";
  const std::vector<StudentRecord> records = {student("Meyer<", "passed", 1),
                                              student("Smith", "wrong", 1, "swapped"),
                                              student("Jones", "wrong", 1, "a wrong factor")};
  const std::string page = report_html(course, records, Names::hidden);
  for (const char* part :
       {"<h1>A &amp; B &lt;script&gt;</h1>", "<p>3 submissions, 1 exercise, 1 point.</p>",
        "<b>swapped</b>, in 4.1 product: 1 of 3 (33 %)<br>q p is not p q.",
        "Chapter 4, “The product”", "1 of 3<td class=\"number\">1<td>"})
    CHECK_MESSAGE(has(page, part), page);
  CHECK_FALSE(has(page, "<b>a wrong factor</b>"));  // no page explains it
  CHECK_FALSE(has(page, "Meyer"));
  CHECK_FALSE(has(page, "Smith"));
  CHECK_FALSE(has(page, "<script"));
  CHECK_FALSE(has(page, "http"));  // it needs nobody
  const std::string with_names = report_html(course, records, Names::shown);
  CHECK(has(with_names, "Meyer&lt;"));
  CHECK(has(with_names, "4.1 wrong"));
  misconceptions_of(unit.id()).clear();
}
