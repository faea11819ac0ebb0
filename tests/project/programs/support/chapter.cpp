/// @file
/// The options that every chapter's program has.
#include "support/chapter.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "project/harness/command.hpp"
#include "project/harness/refusal.hpp"
#include "project/harness/temporary_folder.hpp"

using tumble::test::CommandResult;
using tumble::test::mentions;
namespace fs = std::filesystem;

namespace {

const tumble::test::TemporaryFolder temporary;
const fs::path folder = temporary.path() / "figures";

/// The program of chapter 3, as a reader runs it.
CommandResult chapter(const std::string& arguments) {
  fs::remove_all(folder);
  return tumble::test::run_command("'" + std::string(std::getenv("TUMBLE_CHAPTER")) + "' " +
                                   arguments);
}

std::vector<std::string> files_with(const std::string& extension) {
  std::vector<std::string> names;
  if (!fs::exists(folder)) return names;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == extension) names.push_back(entry.path().filename());
  return names;
}

}  // namespace

TEST_CASE("chapter: prints its tables, and leaves them and its figures") {
  const CommandResult result = chapter("--out '" + folder.string() + "'");
  CHECK(result.status == 0);
  CHECK(mentions(result.output, "A steady turn of 2 rad/s", "times of this machine", "Figures"));
  CHECK(files_with(".csv").size() == 11);
  CHECK(files_with(".svg").size() == 10);
}

TEST_CASE("chapter: one table and nothing else, or the figures and nothing else") {
  CommandResult result = chapter("--only order");
  CHECK(result.status == 0);
  CHECK(mentions(result.output, "rotating x, y, z"));
  CHECK_FALSE(mentions(result.output, "Figures"));
  result = chapter("--figures '" + folder.string() + "'");
  CHECK(result.output == "");
  CHECK(files_with(".svg").size() == 10);
  CHECK(files_with(".csv").empty());
}

TEST_CASE("chapter: one figure and nothing else") {
  const CommandResult result = chapter("--figure order");
  CHECK(result.status == 0);
  CHECK(result.output.starts_with("<svg"));
  CHECK(result.output.ends_with("</svg>\n"));
  CHECK(mentions(chapter("--figure disorder").output, "no figure 'disorder'", "there are: "));
  CHECK(mentions(chapter("--figure order --set h=1").output, "nothing can be set", "order"));
  CHECK(mentions(chapter("--set h=1").output, "--figure"));
}

TEST_CASE("chapter: says what it cannot do") {
  CommandResult result = chapter("--only disorder");
  CHECK(result.status == 2);
  CHECK(mentions(result.output, "03_rotation_matrices", "disorder", "order lock turning_point"));
  result = chapter("--out /dev/null/nowhere");
  CHECK(result.status == 2);
  CHECK(mentions(result.output, "/dev/null/nowhere"));
  CHECK(chapter("--help").status == 0);
  CHECK(mentions(chapter("--help").output, "Usage: ./tumble chapter 3"));
  CHECK(chapter("--unknown").status == 2);
  CHECK(mentions(chapter("--figurs x").output, "tumble: ", "did you mean --figure"));
  CHECK(chapter("--only order >/dev/full").status == 2);
}
