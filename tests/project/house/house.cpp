/// @file
/// The project keeps the law of the house; and each kind of breach is found.
#include <doctest/doctest.h>

#include <cstdlib>

#include "project/harness/command.hpp"
#include "project/harness/skip.hpp"
#include "project/harness/temporary_folder.hpp"
#include "project/house/law.hpp"

using namespace tumble;
namespace fs = std::filesystem;

namespace {

/// A tree of one or two files, and what is against the law there.
std::vector<std::string> broken_in(const std::map<std::string, std::string>& files) {
  const test::TemporaryFolder folder;
  for (const auto& [file, text] : files) folder.write(file, text);
  return house::broken_laws(house::includes_of(folder.path()));
}

std::vector<std::string> circles_in(const std::map<std::string, std::string>& files) {
  const test::TemporaryFolder folder;
  for (const auto& [file, text] : files) folder.write(file, text);
  return house::circles(house::includes_of(folder.path()));
}

std::string including(const std::string& file) { return "#include \"" + file + "\"\n"; }

}  // namespace

TEST_CASE("the project: every include points down to lib/, none leaves the tree") {
  const auto includes = house::includes_of(std::getenv("TUMBLE_ROOT"));
  CHECK(includes.size() > 1000);  // all of them were read
  for (const std::string& broken : house::broken_laws(includes)) FAIL_CHECK(broken);
}

TEST_CASE("the project: no folders include each other in a circle") {
  for (const std::string& circle : house::circles(house::includes_of(std::getenv("TUMBLE_ROOT"))))
    FAIL_CHECK(circle);
}

TEST_CASE("the project: each chapter alone can be handed out, with all that it includes") {
  if (!fs::exists(std::getenv("TUMBLE_JUDGE")))
    return test::skip("presets with sanitizers build the judge of the fixture only");
  for (const auto& exercises :
       fs::directory_iterator(fs::path(std::getenv("TUMBLE_ROOT")) / "exercises")) {
    if (!exercises.is_directory()) continue;
    const int chapter = std::stoi(exercises.path().filename().string());
    CAPTURE(chapter);
    const test::TemporaryFolder folder;
    const fs::path tree = folder.path() / "tree";
    const auto made =
        test::run_command(std::string("'") + std::getenv("TUMBLE_JUDGE") + "' handout --chapters " +
                          std::to_string(chapter) + " '" + tree.string() + "'");
    REQUIRE_MESSAGE(made.status == 0, made.output);
    for (const char* kept :
         {"lib/include/tumble/tumble.hpp", "tests/judge/spec/spec.hpp", "tumble"})
      CHECK_MESSAGE(fs::exists(tree / kept), kept);
    for (const char* held_back : {"solutions", "tests/project", "chapters/for_instructors"})
      CHECK_MESSAGE(!fs::exists(tree / held_back), held_back);
    for (const std::string& broken : house::broken_laws(house::includes_of(tree)))
      FAIL_CHECK(broken);
  }
}

TEST_CASE("an arrow upwards is found, and said with its place") {
  const auto broken = broken_in(
      {{"lib/include/tumble/a.hpp", "\n" + including("judge/b.hpp")}, {"tests/judge/b.hpp", ""}});
  REQUIRE(broken.size() == 1);
  CHECK(broken[0] ==
        "lib/include/tumble/a.hpp:2 includes \"judge/b.hpp\": this arrow does not point down to "
        "lib/");
}

TEST_CASE("what ships and includes what does not is found") {
  for (const char* shipped :
       {"tests/judge/a.cpp", "tests/04_quaternions/a.cpp", "chapters/tour/a.cpp",
        "lib/support/a.hpp", "exercises/04_quaternions/a.cpp"}) {
    CAPTURE(shipped);
    CHECK(broken_in({{shipped, including("project/b.hpp")}, {"tests/project/b.hpp", ""}}).size() ==
          1);
  }
  CHECK(broken_in({{"tests/project/a.cpp", including("judge/b.hpp")}, {"tests/judge/b.hpp", ""}})
            .empty());
}

TEST_CASE("an include that leaves the tree, or leads nowhere, is found") {
  CHECK(broken_in({{"lib/support/a.hpp", including("../../../b.hpp")}}).size() == 1);
  CHECK(broken_in({{"chapters/tour/a.hpp", including("no_such_file.hpp")}}).size() == 1);
}

TEST_CASE("a chapter that includes another one is found: each is handed out alone") {
  for (const char* tree : {"chapters", "tests"}) {
    CAPTURE(tree);
    const std::string root = tree;
    CHECK(broken_in({{root + "/02_b/a.hpp", including("01_a/b.hpp")}, {root + "/01_a/b.hpp", ""}})
              .size() == 1);
  }
}

TEST_CASE("a circle of folders is found, of two and of three") {
  CHECK(circles_in({{"lib/include/tumble/a/a.hpp", including("tumble/b/b.hpp")},
                    {"lib/include/tumble/b/b.hpp", including("tumble/a/c.hpp")},
                    {"lib/include/tumble/a/c.hpp", ""}})
            .size() == 1);
  CHECK(circles_in({{"tests/project/a/a.hpp", including("project/b/b.hpp")},
                    {"tests/project/b/b.hpp", including("project/a/c.hpp")},
                    {"tests/project/a/c.hpp", ""}})
            .size() == 1);
  const auto three = circles_in({{"tests/judge/a/a.hpp", including("judge/b/b.hpp")},
                                 {"tests/judge/b/b.hpp", including("judge/c/c.hpp")},
                                 {"tests/judge/c/c.hpp", including("judge/a/a.hpp")}});
  REQUIRE(three.size() == 1);
  CHECK(three[0] == "tests/judge/a → tests/judge/b → tests/judge/c → tests/judge/a");
}
