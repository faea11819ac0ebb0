/// @file
/// Grades for spreadsheets and for what shows tests.
#include "judge/class/grades.hpp"

#include <doctest/doctest.h>

using namespace tumble::judge;

namespace {

Course small_course() {
  Course course;
  course.units = {{"4.1", "04_quaternions", "product", "", {}, {}},
                  {"4.2", "04_quaternions", "inverse", "", {}, {}}};
  return course;
}

UnitRecord verdict(const std::string& number, const std::string& unit, std::size_t hold) {
  UnitRecord record;
  record.unit = unit, record.number = number, record.laws = 3, record.laws_that_hold = hold;
  record.passed = hold == 3;
  record.summary = record.passed ? "passed" : "wrong";
  record.explanation = "a < b && \"c\"\x01";
  return record;
}

const UnitRecord product = verdict("4.1", "04_quaternions/product", 3);
const UnitRecord inverse = verdict("4.2", "04_quaternions/inverse", 1);

}  // namespace

TEST_CASE("grades.csv: points, and what a spreadsheet must not run") {
  CourseSettings settings = default_settings(small_course());
  settings.credit = Credit::laws;
  const std::string csv = grades_csv(settings, {{"ann", 1, 0, "", {product, inverse}},
                                                {"=cmd(\"x\"),1", 1, 0, "", {product}},
                                                {"eve", 1, 0, "has a link in it: a,b", {}}});
  CHECK(csv ==
        "student,points,of,percent,passed,note,4.1 product,4.2 inverse\n"
        "ann,1.33,2,66.67,1,,1,0.33\n"
        "\"'=cmd(\"\"x\"\"),1\",1,2,50,1,not judged yet: 4.2,1,\n"
        "eve,0,2,0,0,\"has a link in it: a,b\",,\n");
  StudentRecord late{"ann", 1, 0, "", {product}};
  late.out_of_time = true;
  CHECK(grades_csv(settings, {late}).ends_with("\nann,1,2,50,1,1 not judged: no time left,1,\n"));
  const std::string junit = grades_junit(settings, {late});
  CHECK(junit.find("tests=\"2\" failures=\"0\" errors=\"0\" skipped=\"1\"") != std::string::npos);
  CHECK(junit.find("<skipped message=\"not judged: no time left\"/>") != std::string::npos);
}

TEST_CASE("junit.xml: escaped, and nothing that XML cannot say") {
  const std::string junit =
      grades_junit(default_settings(small_course()),
                   {{"a&b", 1, 0, "", {product, inverse}}, {"eve", 1, 0, "is \"bad\"", {}}});
  for (const char* part :
       {"<testsuite name=\"a&amp;b\" tests=\"2\" failures=\"1\" errors=\"0\">",
        "name=\"4.1 04_quaternions/product\" time=\"0.000\"/>",
        "<failure message=\"wrong\">a &lt; b &amp;&amp; &quot;c&quot;?</failure>",
        "<testsuite name=\"eve\" tests=\"1\" failures=\"0\" errors=\"1\">",
        "<error message=\"is &quot;bad&quot;\"/>"})
    CHECK_MESSAGE(junit.find(part) != std::string::npos, junit);
}
