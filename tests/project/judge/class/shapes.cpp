/// @file
/// A class graded in each shape that real systems give.
#include <doctest/doctest.h>

#include <algorithm>

#include "judge/class/csv_table.hpp"
#include "project/harness/command.hpp"
#include "project/judge/class/handed_in_class.hpp"

using namespace tumble;
using test::CommandResult;
namespace fs = std::filesystem;

namespace {

/// A place for one class, and the judge of the fixture's course.
struct Place {
  test::TemporaryFolder work;
  fs::path handed_in = work.path() / "handed in", out = work.path() / "grades";

  CommandResult grade(const fs::path& what, const std::string& options = "") const {
    return test::run_command("'" + test::variable("TUMBLE_FIXTURE_JUDGE").string() + "' grade '" +
                             what.string() + "' --out '" + out.string() + "' " + options);
  }
  judge::CsvTable table(const char* name) const {
    return judge::read_csv(test::text_of(out / name), name);
  }
};

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// The table has these rows and no others.
void check_rows(const Place& place, const test::ExpectedRows& expected) {
  const judge::CsvTable table = place.table("grades.csv");
  CHECK(table.rows.size() == expected.size());
  for (const auto& row : table.rows) {
    CAPTURE(row[0]);
    const auto found = expected.find(row[0]);
    REQUIRE(found != expected.end());
    CHECK(row[1] == found->second.points);
    CAPTURE(row[5]);
    CHECK(says(row[5], found->second.note));
    if (found->second.note.empty()) CHECK(row[5] == "");
  }
}

/// A zip of a folder's content, as a platform makes it.
void zip_folder(const fs::path& folder, const fs::path& zip, const std::string& within = "") {
  std::vector<test::Entry> entries;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file())
      entries.push_back(
          {within + entry.path().lexically_relative(folder).string(), test::text_of(entry.path())});
  test::write_archive(zip, entries);
}

}  // namespace

TEST_CASE("shapes: folders and archives; every entry has a row or a line that says why not") {
  const Place place;
  const auto expected = test::hand_in_folders(place.handed_in);
  const CommandResult graded = place.grade(place.handed_in);
  CHECK_MESSAGE(graded.status == 0, graded.output);
  check_rows(place, expected);
  for (const char* line : {"list of names.txt: neither a folder nor an archive",
                           "tom: a symbolic link, which is not followed", ".git: hidden"})
    CHECK_MESSAGE(says(graded.output, line), graded.output);
  CHECK_FALSE(says(graded.output, "\x1b"));  // no student reaches the terminal
  CHECK(says(graded.output, "\\x1B[2Jpia\\nqux"));
  const judge::CsvTable identical = place.table("identical.csv");
  CHECK(identical.rows.size() == 2);  // the solutions of both exercises
}

TEST_CASE("shapes: Moodle's folders, and its zip as it is") {
  const Place place;
  const auto expected = test::hand_in_moodle(place.handed_in);
  const CommandResult graded = place.grade(place.handed_in);
  CHECK_MESSAGE(graded.status == 0, graded.output);
  check_rows(place, expected);
  const std::string table = test::text_of(place.out / "grades.csv");
  const judge::CsvTable moodle = place.table("moodle.csv");
  CHECK(moodle.header == std::vector<std::string>{"Identifier", "Full name", "Email address",
                                                  "Grade", "Maximum Grade", "Last modified (grade)",
                                                  "Feedback comments"});
  REQUIRE(moodle.rows.size() == 5);
  CHECK(moodle.rows[2][0] == "Participant 4711003");
  CHECK(moodle.rows[2][3] == "1");
  CHECK(says(moodle.rows[2][6], "<li>1.2 twice: wrong, 0 of 1</li>"));

  const Place zipped;
  for (const char* top : {"", "Homework 1/"}) {
    zip_folder(place.handed_in, zipped.work.path() / "all.zip", top);
    const CommandResult again = zipped.grade(zipped.work.path() / "all.zip");
    CHECK_MESSAGE(again.status == 0, again.output);
    CHECK(test::text_of(zipped.out / "grades.csv") == table);
    CHECK_FALSE(says(again.output, "tumble-judge-"));  // nobody's work folder
  }
}

TEST_CASE("shapes: what cannot be taken out of a download is nobody's zero") {
  const Place place;
  const std::string file = "_assignsubmission_file_/";
  std::vector<test::Entry> entries = test::both("H 1/Ann_1" + file);
  const auto link = [](const std::string& path) { return test::Entry{path, "", AE_IFLNK, "/x"}; };
  entries.push_back(link("H 1/Ben_2" + file + "carry.cpp"));
  entries.push_back({"H 1/Ben_2" + file + "twice.cpp", test::twice()});
  entries.push_back(link("./H 1/Cem_3" + file + "carry.cpp"));
  entries.push_back({"H 1/Dan_4" + file + "../../carry.cpp", test::carry()});
  entries.push_back(link("H 1/Eve_5" + file + "venv/bin/python"));
  for (const test::Entry& each : test::both("H 1/Eve_5" + file)) entries.push_back(each);
  entries.push_back({"H 1/Fay_6" + file + std::string(255, 'n') + ".cpp", test::carry()});
  entries.push_back(link("H 1/Gus_7_assignsubmission_file_twice.cpp"));
  entries.push_back({"/etc/x.cpp", "x"});
  test::write_archive(place.work.path() / "all.zip", entries);
  const CommandResult graded = place.grade(place.work.path() / "all.zip");
  CHECK_MESSAGE(graded.status == 1, graded.output);
  check_rows(place, {{"Ann_1", {"2", ""}},
                     {"Ben_2", {"0", "not judged: carry.cpp in the download is a link"}},
                     {"Cem_3", {"0", "not judged: carry.cpp in the download is a link"}},
                     {"Dan_4", {"0", "not judged: ../../carry.cpp in the download leads out"}},
                     {"Eve_5", {"2", "venv/bin/python in the download is a link"}},
                     {"Fay_6", {"0", "not judged: nnn"}},
                     {"Gus_7", {"0", "twice.cpp in the download is a link"}}});
  CHECK(says(graded.output, "/etc/x.cpp: leads out of the archive"));
  CHECK(says(graded.output, "not judged, and no point is lost"));
  const judge::CsvTable moodle = place.table("moodle.csv");
  CHECK(moodle.rows[0][3] == "2");
  CHECK(moodle.rows[1][3] == "");  // no grade is given away
}

TEST_CASE("shapes: Canvas's flat files are one submission a student") {
  const Place place;
  const auto expected = test::hand_in_canvas(place.handed_in);
  const CommandResult graded = place.grade(place.handed_in);
  CHECK_MESSAGE(graded.status == 0, graded.output);
  check_rows(place, expected);
  const judge::CsvTable canvas = place.table("canvas.csv");
  CHECK(canvas.header == std::vector<std::string>{"Student", "ID", "Section", "tumble"});
  CHECK(canvas.rows.front() == std::vector<std::string>{"    Points Possible", "", "", "2"});
  CHECK(canvas.rows[1] == std::vector<std::string>{"doejane", "12345", "", "2"});
  // Canvas gives a file back by the numbers of the student and of a file that it knows.
  const std::string zip = test::text_of(place.out / "feedback.zip");
  CHECK(says(zip, "doejane_12345_67890_feedback.html"));
  CHECK(says(zip, "roebob_LATE_12346_67892_feedback.txt"));

  // In doubt nothing is guessed, and nothing vanishes.
  test::write_file(place.handed_in / "somebody.cpp", "x");
  test::write_files(place.handed_in / "ann", test::both());
  const CommandResult refused = place.grade(place.handed_in);
  CHECK(refused.status == 2);
  CHECK_MESSAGE(
      says(refused.output,
           "looks like a download of Canvas: 3 files in it would be nobody's work, because "
           "Canvas would not have written the name somebody.cpp. If it is one: --from canvas"),
      refused.output);
  const CommandResult doubtful = place.grade(place.handed_in, "--from folders");
  CHECK(says(doubtful.output,
             "doejane_12345_67890_carry.cpp: neither a folder nor an archive; if "
             "Canvas has named it: --from canvas"));
  CHECK(says(doubtful.output, "somebody.cpp: neither"));
  const CommandResult told = place.grade(place.handed_in, "--from canvas");
  CHECK_MESSAGE(says(told.output, "tumble: 5 submissions"), told.output);
  CHECK(says(told.output, "somebody.cpp: neither"));
}

TEST_CASE("shapes: Gradescope's export knows its students") {
  const Place place;
  const auto expected = test::hand_in_gradescope(place.handed_in);
  const CommandResult graded = place.grade(place.handed_in);
  CHECK_MESSAGE(graded.status == 1, graded.output);
  check_rows(place, expected);
  const judge::CsvTable table = place.table("gradescope.csv");
  REQUIRE(table.rows.size() == 5);
  CHECK(table.rows[0][0] == "Bob O'Roe");
  CHECK(table.rows[0][1] == "12346");
  CHECK(table.rows[0][2] == "bob@example.edu");
  CHECK(table.rows[0][3] == "1");
  CHECK(table.rows[0][6] == "2026-11-13 09:00:00.000000000 Z");
  // Who hands in together has the same files, and nobody else is told of.
  const judge::CsvTable identical = place.table("identical.csv");
  for (const auto& row : identical.rows) CHECK(row[1] != "bob@example.edu; sue@example.edu");
  const Place exported;  // as it is unpacked: a folder in a folder
  fs::create_directories(exported.handed_in);
  fs::rename(place.handed_in, exported.handed_in / "assignment_77_export");
  CHECK(says(exported.grade(exported.handed_in).output, "tumble: 5 submissions"));
}

TEST_CASE("shapes: clones of repositories") {
  const Place place;
  const auto expected = test::hand_in_clones(place.handed_in);
  CHECK(place.grade(place.handed_in).status == 0);
  check_rows(place, expected);
}

TEST_CASE("shapes: anything but a class is refused") {
  const Place place;
  test::write_files(place.handed_in / "ann", test::both("exercises/01_crossing/"));
  const CommandResult one = place.grade(place.handed_in / "ann");
  CHECK(one.status == 2);
  CHECK(says(one.output, "looks like one student's work: give the folder that holds"));
  CHECK(says(place.grade(place.work.path() / "nowhere").output, "is not a folder"));
  test::write_archive(place.handed_in / "ann.zip", test::both());
  CHECK(says(place.grade(place.handed_in).output, "two submissions have the name ann"));
  fs::remove_all(place.handed_in / "ann");
  fs::remove(place.handed_in / "ann.zip");
  CHECK(says(place.grade(place.handed_in).output, "holds no submissions"));
  CHECK(
      says(place.grade(place.handed_in, "--from moodel").output, "there is no platform 'moodel'"));
}

TEST_CASE("shapes: a folder of loose files is refused with the reason, and what may help") {
  const Place place;
  for (const char* file : {"a.txt", "b.txt", "c.txt", "doejane_12345_67890_twice.cpp", "carry.cpp"})
    test::write_files(place.handed_in, {{file, "x"}});
  const std::string refused = place.grade(place.handed_in).output;
  CHECK_MESSAGE(says(refused, "a.txt: neither a folder nor an archive"), refused);
  CHECK(says(refused,
             "doejane_12345_67890_twice.cpp: neither a folder nor an archive; if Canvas "
             "has named it: --from canvas"));
  CHECK(says(refused, "5 entries in all"));
}

TEST_CASE("feedback goes back under the platform's names") {
  const Place place;
  test::hand_in_moodle(place.handed_in);
  REQUIRE(place.grade(place.handed_in).status == 0);
  const fs::path unpacked = place.work.path() / "unpacked";
  fs::create_directories(unpacked);
  const auto unzip = test::run_command("cd '" + unpacked.string() + "' && cmake -E tar xf '" +
                                       (place.out / "feedback.zip").string() + "'");
  CHECK_MESSAGE(unzip.status == 0, unzip.output);
  const fs::path cleo = unpacked / "Cleo Ünal_4711003_assignsubmission_file_";
  CHECK(says(test::text_of(cleo / "feedback.txt"), "Cleo Ünal: 1 of 2 points"));
  CHECK(says(test::text_of(cleo / "feedback.html"), "time stands still"));
  CHECK(fs::exists(unpacked / "Dan Li_4711004_assignsubmission_file_/feedback.txt"));
  CHECK(fs::exists(place.out / "feedback/Ann Meyer_4711001.html"));
  const std::string zip = test::text_of(place.out / "feedback.zip");
  REQUIRE(place.grade(place.handed_in).status == 0);
  CHECK(test::text_of(place.out / "feedback.zip") == zip);  // the same bytes
}
