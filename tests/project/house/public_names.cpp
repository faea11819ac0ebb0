/// @file
/// The public names of the library are those of the table in lib/README.md, no more and no fewer.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

using Names = std::set<std::string>;

/// A row of the table: names, and the headers that declare them.
struct Row {
  Names names, headers;
};

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  REQUIRE_MESSAGE(in.is_open(), file << " cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// All that stands between backticks.
Names quoted(const std::string& cell) {
  static const std::regex code("`([^`]+)`");
  Names all;
  for (std::sregex_iterator i(cell.begin(), cell.end(), code), end; i != end; ++i)
    all.insert((*i)[1]);
  return all;
}

/// The rows below the heading "Names".
std::vector<Row> table_in(const std::string& readme) {
  static const std::regex row(R"(\|([^|]*)\|([^|]*)\|([^|]*)\|)");
  std::vector<Row> rows;
  std::smatch cells;
  for (const std::string& line : lines_of(readme.substr(readme.find("## Names"))))
    if (std::regex_match(line, cells, row) && !quoted(cells[2]).empty())
      rows.push_back({quoted(cells[2]), quoted(cells[3])});
  return rows;
}

/// What a line at the left margin declares; empty if it declares nothing with a name of its own.
/// (Formatted code: what stands at the left margin is at the level of a namespace.)
std::string declared_by(const std::string& line) {
  static const std::regex type(
      R"(^(?:requires\(.*\) )?(?:struct|class|enum|enum class|using|concept) (\w+)(?: [:={].*|;|$))");
  static const std::regex function(R"(^(?:[^()=]*[ &*])?(\w+)\()");
  static const std::regex constant(R"(^inline constexpr [^(]*?(\w+)(?: =|\{))");
  std::smatch found;
  if (std::regex_search(line, found, type)) return found[1];
  static const std::regex other("^(?:static_assert|namespace|template <|requires|struct |class )");
  if (std::regex_search(line, other) || line.find("operator") != std::string::npos) return {};
  if (std::regex_search(line, found, constant)) return found[1];
  return std::regex_search(line, found, function) ? found[1].str() : std::string();
}

/// The names that a header declares in `namespace tumble` itself.
Names public_names_in(const std::string& header) {
  static const std::regex opened(R"(^namespace ([\w:]+) \{)"), closed(R"(^\}  // namespace)");
  std::vector<std::string> spaces;
  Names names;
  std::smatch found;
  for (const std::string& line : lines_of(header)) {
    if (std::regex_search(line, found, opened)) spaces.push_back(found[1]);
    if (std::regex_search(line, closed)) spaces.pop_back();
    const bool at_margin = !line.empty() && std::string(" /#}").find(line[0]) == std::string::npos;
    if (!at_margin || spaces != std::vector<std::string>{"tumble"}) continue;
    if (const std::string name = declared_by(line); !name.empty()) names.insert(name);
  }
  return names;
}

/// Everything in which the table and the headers differ, a sentence each.
std::vector<std::string> differences(const std::vector<Row>& table,
                                     const std::map<std::string, Names>& headers) {
  std::vector<std::string> found;
  Names listed;
  for (const Row& row : table) {
    Names declared;
    for (const std::string& header : row.headers)
      if (headers.count(header))
        declared.insert(headers.at(header).begin(), headers.at(header).end());
    for (const std::string& name : row.names)
      if (!declared.count(name))
        found.push_back("lib/README.md lists " + name + ", which none of " + *row.headers.begin() +
                        " … declares in namespace tumble");
    listed.insert(row.names.begin(), row.names.end());
  }
  for (const auto& [header, names] : headers)
    for (const std::string& name : names)
      if (!listed.count(name))
        found.push_back(header + " declares " + name +
                        " in namespace tumble: list it in lib/README.md, or move it to detail");
  return found;
}

std::map<std::string, Names> headers_below(const fs::path& folder) {
  std::map<std::string, Names> headers;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".hpp")
      headers[fs::relative(entry.path(), folder).generic_string()] =
          public_names_in(text_of(entry.path()));
  return headers;
}

}  // namespace

TEST_SUITE("public names") {
  TEST_CASE("the table of lib/README.md lists what the headers declare in namespace tumble") {
    const char* root = std::getenv("TUMBLE_ROOT");
    REQUIRE_MESSAGE(root != nullptr, "TUMBLE_ROOT is not set");
    const auto table = table_in(text_of(fs::path(root) / "lib/README.md"));
    const auto headers = headers_below(fs::path(root) / "lib/include/tumble");
    CHECK(table.size() > 50);  // both were read
    CHECK(headers.at("body/dydt.hpp") == Names{"RigidBodyRhs"});
    for (const std::string& difference : differences(table, headers)) FAIL_CHECK(difference);
  }

  TEST_CASE("each kind of declaration is seen, and what is inside of something else is not") {
    const Names names = public_names_in(R"(#pragma once
namespace tumble {
struct Plain {
  int member(int x);
};
template <class T>
requires(Good<T>&&...) class Constrained {};
enum class Kind { one, two };
using Alias = std::vector<Plain>;
template <class T>
concept Good = true;
inline constexpr int constant = 3;
/// comment(
inline std::vector<std::pair<int, int>> function(int x, double y) {
  return helper(x);
}
[[nodiscard]] const Plain& reference(int x);
Plain::Plain(int x) {}
inline Plain operator+(const Plain& a, const Plain& b) { return a; }
namespace detail {
inline int hidden(int x) { return x; }
}  // namespace detail
}  // namespace tumble
namespace tumble::simd {
struct Elsewhere {};
}  // namespace tumble::simd
)");
    CHECK(names == Names{"Plain", "Constrained", "Kind", "Alias", "Good", "constant", "function",
                         "reference"});
  }

  TEST_CASE("a name too many is found, on either side") {
    const std::vector<Row> table{{{"one", "two"}, {"a.hpp"}}};
    CHECK(differences(table, {{"a.hpp", {"one", "two"}}}).empty());
    CHECK(differences(table, {{"a.hpp", {"one"}}}).size() == 1);
    CHECK(differences(table, {{"a.hpp", {"one", "two", "three"}}}).size() == 1);
    CHECK(differences(table, {{"a.hpp", {"one"}}, {"b.hpp", {"two"}}}).size() == 1);
  }

  TEST_CASE("the table is read below its heading only") {
    const auto table = table_in("| a | `x` | `x.hpp` |\n## Names\n| a | `y` `z` | `y.hpp` |\n");
    REQUIRE(table.size() == 1);
    CHECK(table[0].names == Names{"y", "z"});
    CHECK(table[0].headers == Names{"y.hpp"});
  }
}
