/// @file
/// A second grading into the same folder: what its command leaves out is as it was before.
#include <doctest/doctest.h>

#include "judge/build/work_folder.hpp"
#include "judge/class/csv_table.hpp"
#include "project/harness/command.hpp"
#include "project/judge/class/handed_in_class.hpp"

using namespace tumble;
using test::CommandResult;
namespace fs = std::filesystem;

namespace {

/// Ann is right, Ben has a mistake in the exercise that counts most, Cleo has handed in nothing.
struct WeighedClass {
  judge::WorkFolder work;
  fs::path handed_in = work.path() / "handed in", out = work.path() / "grades";

  WeighedClass() {
    test::write_files(handed_in / "ann", test::both());
    test::write_files(handed_in / "ben",
                      {{"carry.cpp", test::carry()}, {"twice.cpp", test::wrong_twice()}});
    settings(R"({"weights": {"1.2": 99}, "seed": 8231})");
    test::write_file(work.path() / "class.csv", "name,id\nann,1\nben,2\nCleo,3\n");
  }
  void settings(const std::string& text) const {
    test::write_file(work.path() / "course.json", text);
  }
  CommandResult grade(const std::string& arguments) const {
    return test::run_command("cd '" + work.path().string() + "' && '" +
                             test::variable("TUMBLE_FIXTURE_JUDGE").string() + "' grade " +
                             arguments);
  }
  CommandResult grade_all() const {
    return grade("'handed in' --course course.json --roster class.csv");
  }
  std::string table() const { return test::text_of(out / "grades.csv"); }
};

bool it_says(const CommandResult& result, const std::string& part) {
  return result.output.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("graded before: settings and roster that are not given are those of before") {
  const WeighedClass three;
  const CommandResult first = three.grade_all();
  CHECK_MESSAGE(first.status == 0, first.output);
  CHECK_FALSE(it_says(first, "as before"));
  const std::string before = three.table();
  CHECK(before.find("Cleo") != std::string::npos);
  CHECK_FALSE(it_says(three.grade_all(), "as before"));
  for (const char* less : {"'handed in'", "'handed in' --only 1.2 --student ben"}) {
    const CommandResult again = three.grade(less);
    CHECK_MESSAGE(again.status == 0, again.output);
    CHECK_MESSAGE(it_says(again,
                          "tumble: as before: --course grades/course.json, --roster "
                          "grades/roster.csv (to grade without a file, delete it)\n"),
                  again.output);
    CHECK(three.table() == before);
    CHECK(test::text_of(three.out / "course.json") ==
          test::text_of(three.work.path() / "course.json"));
    CHECK_FALSE(fs::exists(three.out / "seed"));
  }
  fs::remove(three.out / "roster.csv");
  CHECK(three.grade("'handed in'").status == 0);
  CHECK(three.table().find("Cleo") == std::string::npos);
}

TEST_CASE("graded before: the submissions are known, too") {
  const WeighedClass three;
  const CommandResult none = three.grade("");
  CHECK(none.status == 2);
  CHECK_MESSAGE(it_says(none, "DIR is required: the folder of the submissions"), none.output);
  REQUIRE(three.grade_all().status == 0);
  const std::string before = three.table();
  const CommandResult again = three.grade("--only 1.2 --student ben");
  CHECK_MESSAGE(again.status == 0, again.output);
  CHECK_MESSAGE(it_says(again, "tumble: as before: DIR " + three.handed_in.string() +
                                   ", --course grades/course.json, --roster grades/roster.csv ("),
                again.output);
  CHECK(it_says(again, "tumble: 1 submission, "));
  CHECK(three.table() == before);
  fs::rename(three.handed_in, three.work.path() / "elsewhere");
  const CommandResult moved = three.grade("--student ben");
  CHECK(moved.status == 2);
  CHECK_MESSAGE(it_says(moved, three.handed_in.string()), moved.output);
  CHECK(three.grade("elsewhere").status == 0);
  CHECK(three.table() == before);
}

TEST_CASE("graded before: other settings are named, and not taken for a part of the class") {
  const WeighedClass three;
  REQUIRE(three.grade_all().status == 0);
  const std::string before = three.table();
  three.settings(R"({"weights": {"1.2": 9}, "seed": 8231, "credit": "laws"})");
  const CommandResult part = three.grade("--course course.json --student ben");
  CHECK(part.status == 2);
  CHECK_MESSAGE(it_says(part,
                        "course.json differs in credit, weights from grades/course.json, with "
                        "which the class was graded: that changes the grades of students who "
                        "are not judged now. Leave out --course, or --only and --student"),
                part.output);
  CHECK(three.table() == before);
  const CommandResult whole = three.grade("--course course.json");
  CHECK_MESSAGE(whole.status == 0, whole.output);
  CHECK_MESSAGE(it_says(whole,
                        "tumble: course.json differs in credit, weights from "
                        "grades/course.json, with which the class was graded before\n"),
                whole.output);
  CHECK(three.table() != before);
  test::write_file(three.work.path() / "class.csv", "name,id\nann,1\nben,2\n");
  const CommandResult other = three.grade("--roster class.csv --only 1.2");
  CHECK(other.status == 2);
  CHECK_MESSAGE(it_says(other, "class.csv differs from grades/roster.csv, with which"),
                other.output);
  CHECK(three.grade("--roster class.csv").status == 0);
  CHECK(three.table().find("Cleo") == std::string::npos);
}

TEST_CASE("graded before: without settings, and now with some") {
  const WeighedClass three;
  REQUIRE(three.grade("'handed in'").status == 0);
  CHECK(it_says(three.grade("--course course.json --only 1.2"),
                "course.json differs in seed, weights from the defaults, with which"));
  CHECK(it_says(three.grade("--roster class.csv --only 1.2"),
                "class.csv differs from no roster, with which"));
  const CommandResult whole = three.grade_all();
  CHECK_MESSAGE(whole.status == 0, whole.output);
  CHECK(it_says(whole,
                "course.json differs in seed, weights from the defaults, with which the "
                "class was graded before\n"));
}

TEST_CASE("graded before: in shards, and merged") {
  const WeighedClass three;
  const std::string all = "'handed in' --course course.json --roster class.csv ";
  REQUIRE(three.grade(all + "--shard 1/2 --out shards").status == 0);
  REQUIRE(three.grade(all + "--shard 2/2 --out shards").status == 0);
  REQUIRE(three.grade("--merge shards").status == 0);
  const std::string before = three.table();
  const CommandResult again = three.grade("'handed in' --only 1.2 --student ben");
  CHECK_MESSAGE(again.status == 0, again.output);
  CHECK(three.table() == before);
}

TEST_CASE("graded before: what the judge needs is what those settings count") {
  const WeighedClass three;
  three.settings(R"({"units": ["1.2"], "curve": false, "seed": 8231})");
  REQUIRE(three.grade_all().status == 0);
  const CommandResult needs =
      test::run_command("cd '" + three.work.path().string() + "' && '" +
                        test::variable("TUMBLE_FIXTURE_JUDGE").string() + "' --needs grade");
  CHECK(needs.output == "spec.01_crossing.twice\n");
}
