/// The version stands in four places, and is the same in all of them.
#include "tumble/version.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

namespace {

/// What the first group of `pattern` holds where it first fits the file; empty if it fits nowhere.
std::string first_in(const std::string& file, const std::string& pattern) {
  const char* root = std::getenv("TUMBLE_ROOT");
  REQUIRE_MESSAGE(root != nullptr, "TUMBLE_ROOT is not set");
  std::ifstream in(std::string(root) + "/" + file);
  REQUIRE_MESSAGE(in.is_open(), file << " cannot be read");
  const std::string text(std::istreambuf_iterator<char>(in), {});
  std::smatch found;
  return std::regex_search(text, found, std::regex(pattern, std::regex::multiline)) ? found[1].str()
                                                                                    : std::string();
}

TEST_SUITE("version") {
  const std::string version(tumble::version);

  TEST_CASE("the macros say what the text says") {
    const std::string joined = std::to_string(TUMBLE_VERSION_MAJOR) + "." +
                               std::to_string(TUMBLE_VERSION_MINOR) + "." +
                               std::to_string(TUMBLE_VERSION_PATCH);
    CHECK(joined == version);
  }
  TEST_CASE("CMake's project has the same version") {
    CHECK(first_in("CMakeLists.txt", R"(^project\(tumble VERSION ([0-9.]+))") == version);
  }
  TEST_CASE("the newest entry of the changelog is about this version") {
    CHECK(first_in("CHANGELOG.md", R"(^## \[([^\]]+)\])") == version);
  }
  TEST_CASE("the citation names this version") {
    CHECK(first_in("CITATION.cff", R"(^version: (\S+))") == version);
  }
}

}  // namespace
