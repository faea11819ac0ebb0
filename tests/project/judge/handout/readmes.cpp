/// @file
/// The README.mds of a hand-out speak of what is there.
#include <regex>

#include "project/judge/handout/whole_tree.hpp"

using namespace tumble::test;

namespace {

/// What stands between backticks and looks like the path of a file or folder of the project.
std::vector<std::string> paths_in(const std::string& page) {
  static const std::regex code("`([^`\n]+)`");
  static const std::regex path(R"([\w.-]+(/[\w.-]+)*/|[\w.-]+(/[\w.-]+)+\.[a-z]+)");
  std::vector<std::string> paths;
  for (std::sregex_iterator it(page.begin(), page.end(), code), end; it != end; ++it)
    if (const std::string text = (*it)[1]; std::regex_match(text, path)) paths.push_back(text);
  return paths;
}

/// Made by a command, or a student's: no part of the tree.
bool comes_later(const std::string& path) {
  for (const char* folder :
       {"build/", "grades/", "students/", "submissions/", "results/", "include/"})
    if (path.find(folder) != std::string::npos) return true;
  return false;
}

bool is_there(const fs::path& tree, const fs::path& page, const std::string& path) {
  for (const fs::path& from : {tree / page.parent_path(), tree, tree / "lib", tree / "lib/include",
                               tree / "lib/include/tumble", tree / "tests", tree / "tests/judge"})
    if (fs::exists(from / path)) return true;
  return false;
}

/// What these speak of is in a package, or what students send and commands make.
bool speaks_of_elsewhere(const fs::path& page) {
  const std::string text = page.string();
  return text.find("/packages/") != std::string::npos || text.find("/class/") != std::string::npos;
}

/// @return how many paths it names
std::size_t check_page(const fs::path& tree, const fs::path& page) {
  const std::string text = text_of(tree / page);
  const std::vector<std::string> paths = paths_in(text);
  for (const std::string& path : paths)
    if (!comes_later(path) && !speaks_of_elsewhere(page))
      CHECK_MESSAGE(is_there(tree, page, path), page << " speaks of " << path);
  for (const char* held_back :
       {"tests/project", "for_instructors", "kill_matrix", "[solutions]", "· solutions"})
    CHECK_MESSAGE(text.find(held_back) == std::string::npos, page << ": " << held_back);
  return paths.size();
}

}  // namespace

TEST_CASE("hand-out: what a README.md names is there, and nothing of what was held back") {
  if (!can_hand_out()) return;
  for (const char* chapters : {"1-4", "1"}) {
    CAPTURE(chapters);
    const HandedOut handed_out(chapters);
    std::size_t named = 0;
    for (const fs::path& page : handed_out.files({".md"}))
      if (page.filename() == "README.md") named += check_page(handed_out.tree(), page);
    CHECK(named > 30);
  }
}

TEST_CASE("hand-out: the chapters of what counts") {
  if (!can_hand_out()) return;
  const TemporaryFolder folder;
  folder.write("course.json", R"({"units": ["1.3", "4"], "seed": 7})");
  const std::string judge = std::string("cd '") + folder.path().string() + "' && '" +
                            std::getenv("TUMBLE_JUDGE") + "' handout ";
  const CommandResult made = run_command(judge + "--course course.json homework");
  REQUIRE_MESSAGE(made.status == 0, made.output);
  CHECK(made.output.find("2 chapters, 13 exercises") != std::string::npos);
  CHECK(fs::exists(folder.path() / "homework/exercises/01_particles/euler_step.cpp"));
  CHECK_FALSE(fs::exists(folder.path() / "homework/tests/02_solvers"));
  CHECK_FALSE(fs::exists(folder.path() / "homework/course.json"));  // it holds the seed
  for (const char* unclear : {"homework2", "--course course.json --chapters 1 homework2"}) {
    const CommandResult refused = run_command(judge + unclear);
    CHECK(refused.status == 2);
    CHECK(refused.output.find("hand out which chapters?") != std::string::npos);
  }
}
