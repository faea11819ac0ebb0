/// @file
/// A machine that compiles, and has no libraries of sanitizers: no mistake has a line then, and
/// every verdict stands.
#include <doctest/doctest.h>

#include "judge/build/work_folder.hpp"
#include "judge/build/worker_build.hpp"
#include "judge/verdict/crash_place.hpp"
#include "project/judge/attacks/submission.hpp"
#include "support/text_file.hpp"

using namespace tumble::judge;
namespace test = tumble::test;

namespace {

/// The fixture's course, with a compiler that links nothing with sanitizers.
Course course_without_sanitizers(const WorkFolder& work) {
  Course course =
      read_course(test::variable("TUMBLE_FIXTURE") / ".." / "tumble_fixture_judge.json");
  const fs::path compiler = work.path() / "c++" / "bin" / "c++";
  tumble::support::write_text_and_folders(
      compiler,
      "#!/bin/sh\ncase \" $* \" in *' -S '* | *' -E '* | *' -c '*) ;;\n"
      "*-fsanitize=*) echo '/usr/bin/ld: cannot find libasan_preinit.o' >&2; exit 1 ;;\nesac\n"
      "exec '" +
          course.toolchain.compiler + "' \"$@\"\n");
  const fs::perms everybody = fs::perms::owner_all | fs::perms::others_read |
                              fs::perms::others_exec | fs::perms::group_exec;
  for (const fs::path& path : {work.path(), work.path() / "c++", compiler.parent_path(), compiler})
    fs::permissions(path, everybody);
  course.toolchain.compiler = compiler.string();
  return course;
}

}  // namespace

TEST_CASE("no sanitizers: a build with them says so, one without goes on") {
  const WorkFolder work;
  const Course course = course_without_sanitizers(work);
  const Unit& unit = course.units.front();
  const Job job{course, unit, course.solution(unit), work.path() / "job"};
  CHECK(build_worker(job).outcome == BuildOutcome::built);
  CHECK_THROWS_AS(build_worker(job, Instrumentation::sanitizers), NoSanitizers);
  const CrashPlace nowhere = crash_place(job, {unit.id(), 1, 1}, 10);
  CHECK(nowhere.place == "");
  CHECK(nowhere.why_not.find("cannot build with sanitizers") != std::string::npos);
}
