/// @file
/// What a student means by a word, and what is said if it means nothing.
#include <doctest/doctest.h>

#include "judge/course/course.hpp"
#include "project/harness/refusal.hpp"

using namespace tumble::judge;

namespace {

Unit unit(const char* number, const char* chapter, const char* name) {
  Unit unit;
  unit.number = number, unit.chapter = chapter, unit.name = name;
  return unit;
}

Course small_course() {
  Course course;
  course.units = {
      unit("1.1", "01_particles", "flatten"),   unit("1.2", "01_particles", "dydt"),
      unit("4.1", "04_quaternions", "product"), unit("4.2", "04_quaternions", "inverse"),
      unit("4.3", "04_quaternions", "rotate"),  unit("9.4", "09_rigid_body", "dydt")};
  return course;
}

}  // namespace

TEST_CASE("select: a unit, a chapter, all, or all functions of a name") {
  CHECK(small_course().select("4.1").size() == 1);
  CHECK(small_course().select("04_quaternions/product").size() == 1);
  CHECK(small_course().select("4").size() == 3);
  CHECK(small_course().select("04").size() == 3);
  CHECK(small_course().select("all").size() == 6);
  CHECK(numbers_of(small_course().select("dydt")) == "1.2 and 9.4");
  CHECK(numbers_of(small_course().select("4")) == "4.1 to 4.3");
}

TEST_CASE("select: a file means the exercise that it is named after") {
  CHECK(numbers_of(small_course().select("flatten.cpp")) == "1.1");
  CHECK(numbers_of(small_course().select("exercises/09_rigid_body/dydt.cpp")) == "9.4");
  CHECK(numbers_of(small_course().select("../elsewhere/dydt.cpp")) == "1.2 and 9.4");
  CHECK_REFUSED(small_course().select("prodct.cpp"),
                "no exercise or chapter 'prodct.cpp'; did you mean product (4.1)?");
}

TEST_CASE("select: a number without its dot") {
  for (const char* written : {"4,2", "42", "4-2", "4 2"})
    CHECK_REFUSED(small_course().select(written), "did you mean 4.2?");
  CHECK_REFUSED(small_course().select("4,9"), "the chapters are");
  CHECK_REFUSED(small_course().select("4,,2"), "the chapters are");
}

TEST_CASE("select: of a word that means nothing, what was probably meant") {
  CHECK_REFUSED(small_course().select("prodct"),
                "no exercise or chapter 'prodct'; did you mean product (4.1)?");
  CHECK_REFUSED(small_course().select("dydx"), "did you mean dydt (1.2 and 9.4)?");
  CHECK_REFUSED(small_course().select("quaternion"), "did you mean chapter 4 (quaternions)?");
  CHECK_REFUSED(small_course().select("flat"), "did you mean flatten (1.1)?");
  CHECK_REFUSED(small_course().select("4.9"), "chapter 4 has 4.1 to 4.3");
  CHECK_REFUSED(small_course().select("7"),
                "the chapters are 1 particles, 4 quaternions, 9 rigid_body; all exercises");
  CHECK_REFUSED(small_course().select("xyzzy"), "the chapters are");
}
