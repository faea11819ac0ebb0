/// @file
/// What is said of files that are no exercise's, beside others that are.
#include "judge/class/sources.hpp"

#include <doctest/doctest.h>

#include "project/harness/command.hpp"
#include "project/judge/attacks/submission.hpp"
#include "project/judge/class/archives.hpp"
#include "project/judge/class/without_files.hpp"
#include "support/text_file.hpp"

using namespace tumble::judge;
namespace support = tumble::support;

namespace {

Course four_units() {
  Course course;
  course.units = {{"1.2", "01_particles", "dydt", "", {}, {}},
                  {"4.1", "04_quaternions", "product", "", {}, {}},
                  {"4.2", "04_quaternions", "inverse", "", {}, {}},
                  {"9.4", "09_rigid_body", "dydt", "", {}, {}}};
  return course;
}

/// The notes on a submission of these files, a line each.
std::string notes_on(const std::vector<std::string>& files) {
  const Course all = four_units();
  const WorkFolder work;
  for (const std::string& file : files)
    support::write_text_and_folders(work.path() / file, "// " + file + "\n");
  std::string notes;
  const Sources sources(all, all.units, {"ben", work.path()});
  for (const std::string& note : sources.notes()) notes += note + "\n";
  return notes;
}

}  // namespace

TEST_CASE("sources: a misspelt file beside a right one is said, with what was meant") {
  CHECK(notes_on({"inverse.cpp", "prodcut.cpp"}) ==
        "prodcut.cpp is not judged: it is not an exercise's name; did you mean product.cpp?\n");
  CHECK(notes_on({"inverse.cpp", "main.cpp", "x/plot.cpp"}) ==
        "not judged, as no exercise has such a name: main.cpp, x/plot.cpp\n");
  CHECK(notes_on({"product.cpp", "dydt.cpp"}) ==
        "dydt.cpp is not judged: it may be in 01_particles/ or in 09_rigid_body/, and lies in "
        "neither\n");
}

TEST_CASE("sources: copies are known by their names, and nothing is said of the course's files") {
  CHECK(notes_on({"product (copy).cpp", "inverse - Kopie.cpp", "01_particles/dydt-1.cpp"}) == "");
  CHECK(notes_on({"exercises/04_quaternions/product.cpp", "tests/a.cpp", "lib/b.cpp",
                  "chapters/c/d.cpp", "build/e.cpp", "solutions/f.cpp", ".git/g.cpp"}) == "");
  CHECK(notes_on({"exercises/04_quaternions/product.cpp", "exercises/04_quaternions/invers.cpp"}) ==
        "exercises/04_quaternions/invers.cpp is not judged: it is not an exercise's name; did you "
        "mean inverse.cpp?\n");
}

TEST_CASE("sources: what was meant for an exercise and is not judged is said") {
  CHECK(notes_on({"inverse.cpp", "product.cc"}) ==
        "product.cc is not judged: it has to be called product.cpp\n");
  CHECK(notes_on({"inverse.cpp", "a/Product (1).cxx", "product"}) ==
        "a/Product (1).cxx is not judged: it has to be called product.cpp\n");
  CHECK(notes_on({"inverse.cpp", "product.cpp", "product.h", "product.txt"}) == "");
  CHECK(notes_on({"inverse.cpp", "build/product.cpp"}) ==
        "build/product.cpp is not judged: we look for no exercise in a folder build/\n");
}

TEST_CASE("sources: what is hidden is nobody's work, in an archive as in a folder") {
  const Course all = four_units();
  const WorkFolder work;
  const std::vector<tumble::test::Entry> files = {{"inverse.cpp", "// new\n"},
                                                  {".history/inverse.cpp", "// old\n"},
                                                  {".history/product.cpp", "// old\n"},
                                                  {"__MACOSX/._product.cpp", "Mac OS X"}};
  tumble::test::write_archive(work.path() / "ben.zip", files);
  for (const tumble::test::Entry& file : files)
    support::write_text_and_folders(work.path() / "ben" / file.path, file.content);
  for (const char* name : {"ben", "ben.zip"}) {
    const Sources sources(all, all.units, {"ben", work.path() / name});
    CHECK(sources.handed_in(all.units[2]) == "inverse.cpp");
    CHECK_FALSE(sources.handed_in(all.units[1]));
    const std::vector<std::string> notes = {
        ".history/product.cpp is not judged: it lies in .history/, a hidden folder"};
    CHECK(sources.notes() == notes);  // nothing of the old file of an exercise that has a new one
  }
}

TEST_CASE("sources: a file in a folder that an operating system put into the archive is named") {
  const Course all = four_units();
  const WorkFolder work;
  tumble::test::write_archive(work.path() / "ben.zip", {{"inverse.cpp", "// new\n"},
                                                        {"__MACOSX/product.cpp", "// whose?\n"}});
  const Sources sources(all, all.units, {"ben", work.path() / "ben.zip"});
  const std::vector<std::string> notes = {
      "__MACOSX/product.cpp is not judged: it lies in __MACOSX/, a folder of the operating system"};
  CHECK(sources.notes() == notes);
}

TEST_CASE(
    "sources: of two exercises with one name, the chapter's folder tells whose a hidden file is") {
  CHECK(notes_on({"01_particles/dydt.cpp", ".history/01_particles/dydt.cpp"}) == "");
  CHECK(notes_on({"inverse.cpp", ".history/01_particles/dydt.cpp", ".history/dydt.cpp"}) ==
        ".history/01_particles/dydt.cpp is not judged: it lies in .history/, a hidden folder\n");
}

TEST_CASE("sources: if all there is lies in a hidden folder, that is said") {
  CHECK(notes_on({".work/product.cpp", ".work/main.cpp", ".git/inverse.cpp"}) ==
        "no exercise found in it; it holds hidden folders only\n"
        ".work/product.cpp is not judged: it lies in .work/, a hidden folder\n");
}

TEST_CASE("sources: what was passed over is said where nothing else is there") {
  CHECK(notes_on({"__MACOSX/product.cpp"}) ==
        "no exercise found in it; it holds folders of the operating system only\n"
        "__MACOSX/product.cpp is not judged: it lies in __MACOSX/, a folder of the operating "
        "system\n");
  CHECK(notes_on({"._product.cpp"}) ==
        "no exercise found in it; it holds what is hidden or an operating system's own: "
        "._product.cpp\n");
}

TEST_CASE("sources: work in solutions/ beside an exercise that is not there is said") {
  CHECK(
      notes_on({"exercises/04_quaternions/inverse.cpp", "solutions/04_quaternions/product.cpp",
                "solutions/04_quaternions/inverse.cpp"}) ==
      "solutions/04_quaternions/product.cpp is not judged: beside a folder exercises/ we look for "
      "no exercise in a folder solutions/\n");
}

TEST_CASE("sources: work in solutions/ beside the untouched exercise is said") {
  Course course;
  course.root = tumble::test::variable("TUMBLE_FIXTURE");
  course.units = {{"1.1", "01_crossing", "carry", "", {}, {}}};
  const Unit& unit = course.units.front();
  const WorkFolder work;
  const auto notes_with = [&](const std::string& in_exercises, const std::string& in_solutions) {
    support::write_text_and_folders(work.path() / "exercises" / (unit.id() + ".cpp"), in_exercises);
    support::write_text_and_folders(work.path() / "solutions" / (unit.id() + ".cpp"), in_solutions);
    return Sources(course, course.units, {"ben", work.path()}).notes();
  };
  const std::string unwritten = support::read_text(course.exercise(unit));
  CHECK(notes_with(unwritten, support::read_text(course.solution(unit))).empty());  // the course's
  CHECK(notes_with("// done\n", "// mine\n").empty());
  const auto notes = notes_with(unwritten, "// mine\n");
  REQUIRE(notes.size() == 1);
  CHECK(notes.front().starts_with("solutions/" + unit.id() + ".cpp is not judged"));
}

TEST_CASE("sources: what is not UTF-8 is converted, and a NUL byte is named") {
  const Course all = four_units();
  const WorkFolder work;
  support::write_text_and_folders(work.path() / "product.cpp",
                                  "// Gr\xf6\xdf"
                                  "e\n");
  const Sources sources(all, all.units, {"ben", work.path()});
  CHECK(support::read_text(sources.of(all.units[1])) == "// Gr\u00f6\u00dfe\n");
  CHECK(sources.notes() ==
        std::vector<std::string>{"product.cpp is Windows-1252: converted to UTF-8"});
}

TEST_CASE("sources: a folder that this machine cannot open is no refusal of the student's work") {
  const Course all = four_units();
  const WorkFolder work;
  support::write_text_and_folders(work.path() / "ben" / "product.cpp", "x");
  const Submission submission{"ben", work.path() / "ben"};
  CHECK_THROWS_AS(
      [&] {
        const tumble::test::WithoutFiles none;
        const Sources sources(all, all.units, submission);
      }(),
      std::runtime_error);
}
