/// @file
/// What was compiled before: it is taken for the very same text, contract and compiler, and for
/// nothing else.
#include "judge/build/object_cache.hpp"

#include <doctest/doctest.h>

#include "judge/build/work_folder.hpp"
#include "project/judge/attacks/submission.hpp"
#include "support/text_file.hpp"

using namespace tumble::judge;
namespace test = tumble::test;
using tumble::support::read_text, tumble::support::write_text_and_folders;

namespace {

Course fixture() {
  return read_course(test::variable("TUMBLE_FIXTURE") / ".." / "tumble_fixture_judge.json");
}

/// The fixture's course in a folder of its own, with a compiler that can be changed.
Course own_course(const fs::path& folder) {
  Course course = fixture();
  fs::copy(course.root, folder / "course", fs::copy_options::recursive);
  const fs::path compiler = folder / "c++" / "bin" / "c++";
  write_text_and_folders(compiler, "#!/bin/sh\nexec '" + course.toolchain.compiler + "' \"$@\"\n");
  const fs::perms everybody = fs::perms::owner_all | fs::perms::others_read |
                              fs::perms::others_exec | fs::perms::group_exec;
  for (const fs::path& path : {folder, folder / "c++", compiler.parent_path(), compiler})
    fs::permissions(path, everybody);
  course.root = folder / "course";
  course.toolchain.compiler = compiler.string();
  return course;
}

struct Place {
  WorkFolder work;
  fs::path cache = work.path() / "cache";
  Course course = fixture();
  const Unit& unit = course.units.front();
  fs::path source = work.path() / "mine.cpp", object = work.path() / "taken.o";
  Place() { fs::create_directory(cache); }

  WorkerBuild compile(const std::string& text, const char* folder, const ObjectCache& known) {
    write_text_and_folders(source, text);
    return compile_unit({course, unit, source, work.path() / folder}, &known);
  }
};

}  // namespace

TEST_CASE("ObjectCache: the same text is taken as it was, another one is not") {
  Place place;
  const ObjectCache cache(place.cache);
  const std::string text = read_text(place.course.solution(place.unit));
  CHECK_FALSE(cache.find(place.unit, text, place.object));
  const WorkerBuild made = place.compile(text, "first", cache);
  REQUIRE(made.outcome == BuildOutcome::built);
  const auto taken = cache.find(place.unit, text, place.object);
  REQUIRE(taken);
  CHECK(taken->outcome == BuildOutcome::built);
  CHECK(read_text(taken->object) == read_text(made.object));
  CHECK_FALSE(cache.find(place.unit, text + "\n", place.object));
  CHECK_FALSE(cache.find(place.course.units.back(), text, place.object));
}

TEST_CASE("ObjectCache: what does not compile keeps the compiler's words") {
  Place place;
  const ObjectCache cache(place.cache);
  const std::string text = "#include \"contract.hpp\"\nint broken( {\n";
  const WorkerBuild made = place.compile(text, "first", cache);
  CHECK(made.outcome == BuildOutcome::does_not_compile);
  const auto taken = cache.find(place.unit, text, place.object);
  REQUIRE(taken);
  CHECK(taken->outcome == made.outcome);
  CHECK(taken->detail == made.detail);
  CHECK_FALSE(made.detail.empty());
}

TEST_CASE("ObjectCache: what does not link is told in the same words the next time") {
  Place place;
  const ObjectCache cache(place.cache);
  const std::string text = "#include \"contract.hpp\"\nint another_name() { return 1; }\n";
  write_text_and_folders(place.source, text);
  const auto build = [&](const char* folder) {
    return build_worker({place.course, place.unit, place.source, place.work.path() / folder},
                        Instrumentation::none, &cache);
  };
  const WorkerBuild made = build("first");
  CHECK(made.outcome == BuildOutcome::wrong_signature);
  REQUIRE(cache.find(place.unit, text, place.object));  // its object: it compiles
  const WorkerBuild again = build("second");
  CHECK(again.outcome == made.outcome);
  CHECK(again.detail == made.detail);
}

TEST_CASE("ObjectCache: what is damaged was never kept, and what cannot be written is compiled") {
  Place place;
  const ObjectCache cache(place.cache);
  const std::string text = read_text(place.course.solution(place.unit));
  REQUIRE(place.compile(text, "first", cache).outcome == BuildOutcome::built);
  for (const char* part : {"object", "build"}) {
    fs::remove(fs::directory_iterator(place.cache)->path() / part);
    CHECK_FALSE(cache.find(place.unit, text, place.object));
  }
  CHECK(place.compile(text, "again", cache).outcome == BuildOutcome::built);
  const ObjectCache nowhere(place.work.path() / "not" / "there");
  CHECK(place.compile(text, "third", nowhere).outcome == BuildOutcome::built);
}

TEST_CASE("ObjectCache: another contract, or another compiler, shares nothing") {
  const WorkFolder work;
  const Course course = own_course(work.path());
  const Unit& unit = course.units.front();
  const std::string text = read_text(course.solution(unit));
  const fs::path object = work.path() / "taken.o";
  const auto known = [&] {
    const auto objects = objects_of_earlier(course);
    REQUIRE(objects);
    return objects->find(unit, text, object).has_value();
  };
  CHECK_FALSE(known());
  compile_unit({course, unit, course.solution(unit), work.path() / "job"},
               objects_of_earlier(course).get());
  CHECK(known());
  const std::string contract = read_text(course.contract(unit));
  tumble::support::write_text(course.contract(unit), contract + "\n// more is demanded\n");
  CHECK_FALSE(known());
  tumble::support::write_text(course.contract(unit), contract);
  CHECK(known());
  tumble::support::write_text(course.toolchain.compiler,
                              read_text(course.toolchain.compiler) + "# another one\n");
  CHECK_FALSE(known());
}

TEST_CASE("objects_of_earlier: a judge that speaks in other words shares nothing") {
  const WorkFolder work;
  const Course course = own_course(work.path());
  const Unit& unit = course.units.front();
  const fs::path words = course.root / "tests" / "judge" / "build" / "diagnostics.cpp";
  const std::string text = "#include \"contract.hpp\"\nint broken( {\n";
  const auto known = [&] {
    return objects_of_earlier(course)->find(unit, text, work.path() / "taken.o").has_value();
  };
  write_text_and_folders(words, "// old words\n");
  write_text_and_folders(work.path() / "broken.cpp", text);
  compile_unit({course, unit, work.path() / "broken.cpp", work.path() / "job"},
               objects_of_earlier(course).get());
  CHECK(known());
  write_text_and_folders(words, "// new words\n");
  CHECK_FALSE(known());
}

TEST_CASE("objects_of_earlier: verdicts on stubs are not kept from one command to the next") {
  const Course course = fixture();
  const auto objects = objects_of_earlier(course);
  REQUIRE(objects);
  objects->keep_verdict_on_stub(course.units.front(), "anything");
  CHECK_FALSE(objects->verdict_on_stub(course.units.front()));
}
