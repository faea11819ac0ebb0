/// @file
/// Which folders and archives are submissions, and which of their files are meant.
#include "judge/class/submissions.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>

#include "judge/build/work_folder.hpp"
#include "project/harness/refusal.hpp"

using namespace tumble::judge;

namespace {

Course course_with_two_dydt() {
  Course course;
  course.units = {{"1.2", "01_particles", "dydt", "", {}, {}},
                  {"4.1", "04_quaternions", "product", "", {}, {}},
                  {"9.4", "09_rigid_body", "dydt", "", {}, {}}};
  return course;
}

std::string file_of(const std::string& unit, const std::vector<fs::path>& paths,
                    const std::vector<Unit>& counted = course_with_two_dydt().units) {
  const auto files = files_of_units(course_with_two_dydt(), counted, paths);
  const auto found = files.find(unit);
  return found == files.end() ? "" : found->second.string();
}

void touch(const fs::path& file) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "x";
}

}  // namespace

TEST_CASE("a unit's file: in exercises/, in its chapter's folder, or by a name that is unique") {
  const std::string unit = "04_quaternions/product";
  CHECK(file_of(unit, {"a/04_quaternions/product.cpp", "b/c/exercises/04_quaternions/product.cpp",
                       "product.cpp"}) == "b/c/exercises/04_quaternions/product.cpp");
  CHECK(file_of(unit, {"product.cpp", "deep/er/04_quaternions/product.cpp"}) ==
        "deep/er/04_quaternions/product.cpp");
  CHECK(file_of(unit, {"old/04_quaternions/product.cpp", "04_quaternions/product.cpp"}) ==
        "04_quaternions/product.cpp");
  CHECK(file_of(unit, {"homework 4/product.cpp"}) == "homework 4/product.cpp");
  for (const char* other :
       {"build/product.cpp", "tests/04_quaternions/product.cpp", "04_quaternions/product.cpp.bak"})
    CHECK(file_of(unit, {other}) == "");
  const fs::path ours = "solutions/04_quaternions/product.cpp";
  CHECK(file_of(unit, {ours}) == ours);
  CHECK(file_of(unit, {ours, "exercises/04_quaternions/inverse.cpp"}) == "");
  CHECK(file_of("01_particles/dydt", {"dydt.cpp"}) == "");  // which of the two?
  CHECK(file_of("01_particles/dydt", {"01_particles/dydt.cpp", "09_rigid_body/dydt.cpp"}) ==
        "01_particles/dydt.cpp");
  const std::vector<Unit> only_the_last = course_with_two_dydt().select("9");
  CHECK(file_of("09_rigid_body/dydt", {"dydt.cpp"}, only_the_last) == "dydt.cpp");
  CHECK(file_of("01_particles/dydt", {"dydt.cpp"}, only_the_last) == "");
}

TEST_CASE("submissions: folders and archives by their names, and nothing else") {
  const WorkFolder class_folder;
  const fs::path& folder = class_folder.path();
  touch(folder / "meyer" / "a.cpp");
  touch(folder / "ann.b.zip");
  touch(folder / "eve.tar.gz");
  touch(folder / ".git" / "x");
  touch(folder / "list.txt");
  fs::create_symlink("/etc", folder / "link");
  const std::vector<Submission> all = submissions_in({folder});
  REQUIRE(all.size() == 3);
  CHECK(all[0].student == "ann.b");
  CHECK(all[0].is_archive);
  CHECK(all[1].student == "eve");
  CHECK(all[2].student == "meyer");
  CHECK_FALSE(all[2].is_archive);

  touch(folder / "meyer.zip");
  CHECK_REFUSED(submissions_in({folder}), "two submissions have the name meyer");
  const WorkFolder empty;
  CHECK_REFUSED(submissions_in({empty.path()}), "holds no submissions");
  CHECK_REFUSED(submissions_in({folder / "nowhere"}), "nowhere is no folder");
}

TEST_CASE("files below a folder: links are named and not followed, hidden folders left out") {
  const WorkFolder work;
  touch(work.path() / "a" / "b.cpp");
  touch(work.path() / ".git" / "c.cpp");
  fs::create_directory_symlink("/usr", work.path() / "usr");
  std::vector<fs::path> files = files_below(work.path());
  std::sort(files.begin(), files.end());
  CHECK(files == std::vector<fs::path>{"a/b.cpp", "usr"});
}
