/// @file
/// Tables that platforms write, and what they take back.
#include "judge/class/roster.hpp"

#include <doctest/doctest.h>

#include <fstream>

#include "judge/build/work_folder.hpp"
#include "judge/class/canonical_names.hpp"
#include "judge/class/feedback.hpp"
#include "judge/class/final_grade.hpp"
#include "judge/class/gradescope_metadata.hpp"
#include "judge/class/lms_grades.hpp"
#include "judge/class/one_student_each.hpp"
#include "project/harness/refusal.hpp"
#include "project/harness/skip.hpp"
#include "project/judge/class/archives.hpp"

using namespace tumble::judge;

namespace {

Roster roster_in(const std::string& text) {
  const WorkFolder folder;
  std::ofstream(folder.path() / "class.csv", std::ios::binary) << text;
  return read_roster(folder.path() / "class.csv");
}

CourseSettings homework() {
  Course course;
  course.units = {{"4.1", "04_quaternions", "product", "", {}, {}}};
  CourseSettings settings = default_settings(course);
  settings.title = "Homework 1";
  return settings;
}

StudentRecord graded(const std::string& name, const std::string& id, bool passed) {
  UnitRecord unit;
  unit.unit = "04_quaternions/product", unit.number = "4.1", unit.passed = passed;
  unit.summary = passed ? "passed" : "wrong", unit.source = 17;
  unit.explanation = "a < b";
  StudentRecord record{name + "_" + id, 1, 0, "", {unit}};
  record.who = {name, id, ""};
  return record;
}

}  // namespace

TEST_CASE("tables: quotes, separators, byte order marks") {
  const CsvTable table = read_csv(
      "\xef\xbb\xbf"
      "a;\"b;\"\"c\"\"\nd\";e\r\n1;2\r\n\r\n",
      "t.csv");
  CHECK(table.header == std::vector<std::string>{"a", "b;\"c\"\nd", "e"});
  REQUIRE(table.rows.size() == 1);
  CHECK(table.rows[0] == std::vector<std::string>{"1", "2", ""});
  CHECK(read_csv(tumble::test::utf16("x\ty\n1\t2\n"), "t").header.size() == 2);
  CHECK_REFUSED(read_csv("a,b\n\"1,2\n", "t.csv"), "t.csv, line 2: a quote is not closed");
  CHECK_REFUSED(read_csv("a\n1,2\n", "t.csv"),
                "t.csv: the row of 1 has 2 fields, the header has 1");
  CHECK_REFUSED(read_csv("", "t.csv"), "t.csv is empty");
  CHECK(without_formula("=1+1") == "'=1+1");
  CHECK(without_formula("-") == "-");
}

TEST_CASE("rosters: each platform's own table") {
  const Roster moodle = roster_in(
      "Identifier,Full name,Email address,Status,Grade,Maximum Grade,Last modified "
      "(submission),Last modified (grade),Feedback comments\n"
      "Participant 4711001,Ann Meyer,ann@x.edu,Submitted,,4.00,\"Tuesday, 1 December 2026, 11:59 "
      "PM\",-,\nParticipant 4711002,Ben Kim,ben@x.edu,No submission,,4.00,-,-,\n");
  CHECK(moodle.lms == Lms::moodle);
  REQUIRE(moodle.members.size() == 2);
  CHECK(moodle.members[0].who.id == "4711001");
  CHECK(moodle.members[0].handed_in == "Tuesday, 1 December 2026, 11:59 PM");
  CHECK(moodle.members[1].handed_in == "");

  const Roster canvas = roster_in(
      "Student,ID,SIS User ID,SIS Login ID,Section,Homework 1 (98765)\n"
      "    Points Possible,,,,,4\n\"Doe, Jane\",12345,u1,jdoe,A,\n\"Student, Test\",99,,,A,\n");
  CHECK(canvas.lms == Lms::canvas);
  REQUIRE(canvas.members.size() == 1);
  CHECK(canvas.members[0].login == "jdoe");

  const Roster gradescope = roster_in("First Name,Last Name,SID,Email\nJane,Doe,7,j@x.edu\n");
  CHECK(gradescope.lms == Lms::gradescope);
  CHECK(gradescope.members[0].who.name == "Jane Doe");
}

TEST_CASE("rosters: whose submission it is") {
  const Roster roster = roster_in(
      "name,email,id\n\"Doe, Jane\",jane@x.edu,1\nAnn Lee,ann@x.edu,2\nAnn Lee,lee@x.edu,3\n");
  const MemberFinder members(roster);
  const auto number_of = [&](Submission submission) {
    const Member* member = members.find(submission);
    return member ? member->who.id : "";
  };
  CHECK(number_of({"doejane_12345", "", false, {}, {"doejane", "12345", ""}}) == "1");
  CHECK(number_of({"jane", ""}) == "1");
  CHECK(number_of({"Jane Doe", ""}) == "1");
  CHECK(number_of({"JANE@x.edu", ""}) == "1");
  CHECK(number_of({"Ann Lee", ""}) == "");  // which of the two?
  CHECK(number_of({"x", "", false, {}, {"Ann Lee", "3", ""}}) == "3");
  CHECK(number_of({"bob", ""}) == "");
}

TEST_CASE("rosters: two students of one number are refused, one student in two rows is one") {
  CHECK(roster_in("name,id\nAnn,7\nBen,07\nAnn,7\n").members.size() == 2);
  CHECK_REFUSED(
      roster_in("name,id\nAnn,7\nBen,7\n"),
      "has the number 7 twice, of Ann and of Ben: we could not tell whose grade is whose");
}

TEST_CASE("rosters: one student has one row, and who could be two is nobody") {
  const Roster roster = roster_in("name,id\nAnn Lee,1\nBen Kim,2\nBen Kim,3\n");
  std::vector<Submission> both = {{"Ann Lee", ""}, {"ann lee ", ""}};
  CHECK_REFUSED(match(roster, both),
                "the submissions Ann Lee and ann lee  are of one student on the roster, Ann Lee: ");
  std::vector<Submission> attempts = {{"Ann Lee", ""}, {"Ann Lee", ""}, {"Ben Kim", ""}};
  const RosterMatch result = match(roster, attempts);
  CHECK(result.missing.size() == 2);
  CHECK(result.strangers ==
        std::vector<std::string>{"Ben Kim: this means several there, so it counts for none"});
}

TEST_CASE("course.json: a name that two students have is refused, for it would be for both") {
  ClassRoll roll;
  roll.submissions = {{"Ann Lee_1", "", false, {}, {"Ann Lee", "1", ""}},
                      {"Ann Lee_2", "", false, {}, {"Ann Lee", "2", ""}}};
  ClassRules rules;
  rules.extensions["1"] = rules.extensions["Ann Lee_2"] = "2026-12-08T23:59:00Z";
  CHECK(with_names_of_rows(rules, everybody(roll)).extensions == rules.extensions);
  rules.overrides["ann lee"] = {};
  CHECK_REFUSED(with_names_of_rows(rules, everybody(roll)),
                "course.json, overrides: ann lee means 2 students, Ann Lee_1 and Ann Lee_2: ");
  rules.overrides = {{"ANN LEE_2", {}}};
  CHECK(with_names_of_rows(rules, everybody(roll)).overrides.contains("Ann Lee_2"));
}

TEST_CASE("Moodle: its worksheet, filled in") {
  const Roster roster = roster_in(
      "Identifier,Full name,Email address,Status,Grade,Maximum Grade,Last modified "
      "(grade),Feedback "
      "comments\nParticipant 1,Ann,a@x,Submitted,,4.00,-,\nParticipant 2,Ben,b@x,No submission,,"
      "4.00,-,\n");
  StudentRecord absent{"Ben", 1, 0, "", {}};
  absent.who = {"Ben", "2", "b@x"};
  absent.absent = true;
  const CsvTable table = read_csv(
      lms_grades(Lms::moodle, homework(), {graded("Ann", "1", true), absent}, &roster), "m");
  CHECK(table.header == roster.table.header);
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0][3] == "Submitted");
  CHECK(table.rows[0][4] == "1");
  CHECK(table.rows[0][7].starts_with("<p>1 of 1 points</p>"));
  CHECK(table.rows[1][4] == "");  // no points are not zero points
}

TEST_CASE("Canvas: the gradebook's column is found, and its other columns kept") {
  const Roster roster = roster_in(
      "Student,ID,SIS User ID,SIS Login ID,Section,Quiz (1),Homework 1 (98765)\n"
      "    Points Possible,,,,,3,4\n\"Doe, Jane\",12345,u1,jdoe,A,3,\n");
  const std::string csv =
      lms_grades(Lms::canvas, homework(), {graded("Doe, Jane", "12345", true)}, &roster);
  CHECK(csv ==
        "Student,ID,SIS User ID,SIS Login ID,Section,Homework 1 (98765)\n"
        "    Points Possible,,,,,1\n\"Doe, Jane\",12345,u1,jdoe,A,1\n");
}

TEST_CASE("Gradescope: who is who") {
  const auto all = read_gradescope_metadata(
      "---\r\nsubmission_1:\r\n  :submitters:\r\n  - :name: \"A \\\"B\\\" C\"\r\n    :sid: null\r\n"
      "    :email: a@x.edu\r\n  :created_at: 2026-11-12 22:43:59 Z\r\n"
      "  :history:\r\n  - :id: 7\r\n    :name: nobody\r\n'submission_2':\r\n  :submitters: []\r\n");
  REQUIRE(all.size() == 2);
  REQUIRE(all.at("submission_1").submitters.size() == 1);
  CHECK(all.at("submission_1").submitters[0].name == "A \"B\" C");
  CHECK(all.at("submission_1").submitters[0].id == "");
  CHECK(all.at("submission_1").created_at == "2026-11-12 22:43:59 Z");
  CHECK(all.at("submission_2").submitters.empty());
  CHECK_REFUSED(read_gradescope_metadata("- a\n- b\n"), "it is not a list of submissions");
  CHECK_REFUSED(read_gradescope_metadata(""), "it names no submission");
}

TEST_CASE("feedback: what a student reads, and what not yet") {
  CourseSettings settings = homework();
  const StudentRecord record = graded("Ann <b>", "1", false);
  CHECK(feedback_text(settings, record).find("4.1 product: wrong, 0 of 1") != std::string::npos);
  CHECK(feedback_text(settings, record).find("a < b") != std::string::npos);
  const std::string page = feedback_html(settings, record);
  CHECK(page.find("Ann &lt;b&gt;: <b>0 of 1 points</b>") != std::string::npos);
  CHECK(page.find("a &lt; b") != std::string::npos);
  CHECK(page.find("http") == std::string::npos);  // it needs nobody
  settings.hidden = {"04_quaternions/product"};
  settings.due = "2999-01-01T00:00:00Z";
  CHECK(feedback_html(settings, record).find("a &lt; b") == std::string::npos);
  CHECK(feedback_text(settings, record).find("shown after the due date") != std::string::npos);
  settings.due = "1999-01-01T00:00:00Z";
  CHECK(feedback_text(settings, record).find("a < b") != std::string::npos);
}

namespace {

const std::string composed = "Jos\u00e9 M\u00fcller", decomposed = "Jose\u0301 Mu\u0308ller";

}  // namespace

TEST_CASE("rosters: an accent is the same however it is written, in the roster or in a folder") {
  if (!compares_canonically()) return tumble::test::skip("tumble was built without utf8proc");
  for (const std::string& listed : {composed, decomposed})
    for (const std::string& named : {composed, decomposed}) {
      const Roster roster = roster_in("name,id\n" + listed + ",7\nAnn,8\n");
      std::vector<Submission> all = {{named, ""}, {"Ann", ""}};
      const RosterMatch result = match(roster, all);
      CHECK(result.missing.empty());
      CHECK(result.strangers.empty());
      CHECK(all[0].who.id == "7");
    }
  CHECK(canonical(decomposed) == composed);
}

TEST_CASE("rosters: neither case nor punctuation of any script tells two students apart") {
  if (!compares_canonically()) return tumble::test::skip("tumble was built without utf8proc");
  const Roster roster = roster_in("name,id\nZo\u00eb O\u2019Brien,1\nJos\u00e9,2\nJose,3\n");
  const MemberFinder members(roster);
  const auto number_of = [&](const std::string& name) {
    const Member* member = members.find({name, ""});
    return member ? member->who.id : "";
  };
  CHECK(number_of("ZO\u00cb O'BRIEN") == "1");
  CHECK(number_of("Zoe\u0308\u00a0O\u2019Brien\u200b") == "1");
  CHECK(number_of("Jose\u0301") == "2");
  CHECK(number_of("Jose") == "3");  // an accent does
}

TEST_CASE("course.json and --student: an accent is the same however it is written") {
  if (!compares_canonically()) return tumble::test::skip("tumble was built without utf8proc");
  StudentRecord record{composed, 1, 0, "", {}};
  CHECK(is_called(record, decomposed));
  record.student = "submission_1", record.who.name = decomposed;
  CHECK(is_called(record, "JOS\u00c9 M\u00dcLLER"));
  CHECK(!is_called(record, "Jose Muller"));
}

TEST_CASE("Canvas: the gradebook's column is found, however an accent in it is written") {
  if (!compares_canonically()) return tumble::test::skip("tumble was built without utf8proc");
  CourseSettings settings = homework();
  settings.title = "\u00dcbung 1";
  const Roster roster =
      roster_in("Student,ID,SIS Login ID,Section,U\u0308bung 1 (98765)\n\"Doe, Jane\",12,j,A,\n");
  const std::string csv =
      lms_grades(Lms::canvas, settings, {graded("Doe, Jane", "12", true)}, &roster);
  CHECK(csv.starts_with("Student,ID,SIS Login ID,Section,U\u0308bung 1 (98765)\n"));
}

TEST_CASE("names: what is not UTF-8 stays as it is") {
  CHECK(canonical("M\xfcller") == "M\xfcller");
  CHECK(folded("M\xfcller") == "m\xfcller");
  CHECK(letters_of("M\xfcller, Jo") == "m\xfcllerjo");
}
