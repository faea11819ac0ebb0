/// @file
/// The same seed asks the same questions with every compiler: no two random draws are in a place
/// where the language leaves open which one comes first. Arguments in parentheses are evaluated in
/// any order, and so are both sides of a product; in braces, the first comes first.
#include <doctest/doctest.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "support/text_file.hpp"

namespace fs = std::filesystem;

namespace {

std::string without_comments(const std::string& text) {
  return std::regex_replace(text, std::regex("//[^\n]*"), "");
}

/// The places of two draws in one order or the other: "Vec3(any_number(0, 1), any_number(0, 1)".
std::vector<std::string> unordered_draws(const std::string& text) {
  const std::string draw = R"(any_\w+\([^(){};]*\)(?:\.\w+\(\))?)";
  static const std::regex arguments(R"(\w\((?:[^(){};,]*,\s*)*[^(){};,]*)" + draw +
                                    R"([^(){};,]*,(?:[^(){};]|\w+\()*any_\w+\()");
  static const std::regex operands(draw + R"(\s*[-+*/]\s*any_\w+\()");
  std::vector<std::string> found;
  for (const std::regex* each : {&arguments, &operands})
    for (std::sregex_iterator it(text.begin(), text.end(), *each), end; it != end; ++it)
      found.push_back(it->str());
  return found;
}

/// The sources of all specs, and of what they share.
std::vector<fs::path> specs() {
  std::vector<fs::path> files;
  const fs::path tests = fs::path(std::getenv("TUMBLE_ROOT")) / "tests";
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(tests)) {
    const std::string within = fs::relative(entry.path(), tests).string();
    const bool is_chapter = std::isdigit(static_cast<unsigned char>(within.front())) != 0;
    const bool is_source = entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp";
    if (is_source && (is_chapter || within.starts_with("judge/spec/")))
      files.push_back(entry.path());
  }
  return files;
}

}  // namespace

TEST_CASE("draws: where it is open which comes first is found") {
  CHECK(unordered_draws("const Vec3 s(any_number(0.2, 2), any_number(0.2, 2));").size() == 1);
  CHECK(unordered_draws("tensor(any_moments().cwiseInverse(), any_rotation())").size() == 1);
  CHECK(unordered_draws("Body body(any_number(1, 5), tensor(m, any_rotation()));").size() == 1);
  CHECK(unordered_draws("x + any_number(0.3, 2) * any_direction()").size() == 1);
  CHECK(unordered_draws("const Vec3 s{any_number(0.2, 2), any_number(0.2, 2)};").empty());
  CHECK(unordered_draws("const double t = any_number(-2, 2), h = any_number(0.1, 1);").empty());
  CHECK(unordered_draws("for (const Vec3& a : {any_vector(), any_vector()}) f(a);").empty());
}

TEST_CASE("draws: every spec draws in one order") {
  const std::vector<fs::path> files = specs();
  REQUIRE(files.size() > 54);
  for (const fs::path& file : files) {
    const std::string text = without_comments(tumble::support::read_text(file));
    for (const std::string& place : unordered_draws(text)) FAIL_CHECK(file << ": " << place);
  }
}
