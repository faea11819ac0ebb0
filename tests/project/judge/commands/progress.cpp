/// @file
/// Which exercise the judge sends a student to.
#include "judge/course/progress.hpp"

#include <doctest/doctest.h>

#include "project/harness/temporary_folder.hpp"

using namespace tumble::judge;

TEST_CASE("progress: the next exercise is of the same chapter, then of a later one, then of any") {
  const tumble::test::TemporaryFolder folder;
  Course course;
  course.root = course.state = folder.path();
  for (const char* number : {"1.1", "2.1", "2.2", "2.3", "3.1"}) {
    Unit unit;
    unit.number = number;
    unit.chapter = "0" + unit.chapter_number();
    unit.name = number;
    course.units.push_back(unit);
  }
  Progress progress(course);
  const auto next_after_passing = [&](std::size_t k) {
    progress.of(course.units[k]).last = "passed";  // the file is missing, so it has not changed
    const auto next = progress.next_open_after(course.units[k]);
    return next ? next->number : "none";
  };
  CHECK(next_after_passing(2) == "2.1");  // began with 2.2
  CHECK(next_after_passing(1) == "2.3");
  CHECK(next_after_passing(3) == "3.1");
  CHECK(next_after_passing(4) == "1.1");
  CHECK(progress.next_open()->number == "1.1");
  CHECK(next_after_passing(0) == "none");
}
