/// @file
/// Which files of a submission are meant.
#include "judge/class/submissions.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>

#include "judge/build/work_folder.hpp"
#include "project/judge/class/without_files.hpp"

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

TEST_CASE("a unit's file: however its student has spelt it") {
  for (const char* name :
       {"Product.cpp", "PRODUCT.CPP", "product (1).cpp", "product(2).cpp", "product-1.cpp",
        "product (copy).cpp", "product - Kopie.cpp", "product - Copy (2).cpp",
        "product (copy 2).cpp", "product_-_Copy.cpp", "Copy of product.cpp",
        "Kopie von product.cpp", "product (1) (1).cpp", "product.cpp.txt", "Product - Copy.cpp",
        "product copy.cpp", "product 2.cpp", "Exercises/04_Quaternions/product.cpp"})
    CHECK_MESSAGE(file_of("04_quaternions/product", {name}) == name, name);
  for (const char* other : {"my_product.cpp", "product.hpp", "product.txt", "._product.cpp",
                            "__MACOSX/product.cpp", "product.cpp~", "-1.cpp"})
    CHECK_MESSAGE(file_of("04_quaternions/product", {other}) == "", other);
}

TEST_CASE("a unit's file: of several, by a rule that is the same everywhere") {
  const auto counted = [](std::vector<fs::path> paths) {
    const std::string first = file_of("04_quaternions/product", paths);
    std::reverse(paths.begin(), paths.end());
    CHECK(file_of("04_quaternions/product", paths) == first);
    return first;
  };
  CHECK(counted({"v1/product.cpp", "v10/product.cpp", "v2/product.cpp"}) == "v10/product.cpp");
  CHECK(counted({"hw1/product.cpp", "hw1-fixed/product.cpp"}) == "hw1-fixed/product.cpp");
  CHECK(counted({"product.cpp", "product-1.cpp", "product-2.cpp"}) == "product-2.cpp");
  CHECK(counted({"product.cpp", "product (1).cpp"}) == "product (1).cpp");
  CHECK(counted({"product.cpp.txt", "product.cpp"}) == "product.cpp");
  // An archive stands for a folder: its ending counts for nothing.
  for (const char* ending : {".zip", ".tar.gz", ".tgz", ".7z", ".tar.bz2", ".ZIP"})
    for (const char* newer : {"hw-1", "hw (1)", "hw2"}) {
      const std::string second = std::string(newer) + ending + "/product.cpp";
      CHECK(counted({std::string("hw") + ending + "/product.cpp", second}) == second);
    }
  CHECK(counted({"two/hw.zip/product.cpp", "two/hw-1.tar.gz/product.cpp"}) ==
        "two/hw-1.tar.gz/product.cpp");
  CHECK(counted({"a/product.cpp", "B/product.cpp"}) == "B/product.cpp");
  CHECK(counted({"v9/product.cpp", "exercises/04_quaternions/product.cpp"}) ==
        "exercises/04_quaternions/product.cpp");
  CHECK(counted({"deep/er/product.cpp", "z.cpp", "a/product.cpp"}) == "a/product.cpp");
  const auto chosen = choose_files(course_with_two_dydt(), course_with_two_dydt().units,
                                   {"v1/product.cpp", "v2/product.cpp"});
  CHECK(chosen.at("04_quaternions/product").others == std::vector<fs::path>{"v1/product.cpp"});
}

TEST_CASE("files below a folder: a machine that cannot read is no empty folder") {
  const WorkFolder work;
  touch(work.path() / "a" / "b.cpp");
  const tumble::test::WithoutFiles none;
  CHECK_THROWS_AS(files_below(work.path()), std::runtime_error);
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

TEST_CASE("hidden sources: seen in passing, and what cannot be opened stops nothing") {
  const WorkFolder work;
  for (const char* folder : {"a", ".work/b", ".git", ".closed"})
    touch(work.path() / folder / "b.cpp");
  touch(work.path() / ".work" / "notes.txt");
  fs::permissions(work.path() / ".closed", fs::perms::none);
  const std::vector<fs::path> found = hidden_sources_below(work.path());
  CHECK(std::find(found.begin(), found.end(), ".work/b/b.cpp") != found.end());
  CHECK(found.size() <= 2);  // root opens all folders
  CHECK(files_below(work.path()) == std::vector<fs::path>{"a/b.cpp"});
  fs::permissions(work.path() / ".closed", fs::perms::owner_all);
}
