/// @file
/// The public names of the library are those of the two tables in lib/README.md, no more and no
/// fewer: `namespace tumble` itself, and the namespaces of topics.
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
using NamesBySpace = std::map<std::string, Names>;

/// A row of a table: the namespace, names in it, and the headers that declare them.
struct Row {
  std::string space;
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

/// The rows below the heading "Names". A first cell with `tumble::topic` in it says which namespace
/// this row and those below it are about; before the first of these it is `tumble`.
std::vector<Row> tables_in(const std::string& readme) {
  static const std::regex row(R"(\|([^|]*)\|([^|]*)\|([^|]*)\|)");
  std::vector<Row> rows;
  std::smatch cells;
  std::string space = "tumble";
  for (const std::string& line : lines_of(readme.substr(readme.find("## Names")))) {
    if (!std::regex_match(line, cells, row) || quoted(cells[2]).empty()) continue;
    if (const Names named = quoted(cells[1]); !named.empty()) space = *named.begin();
    rows.push_back({space, quoted(cells[2]), quoted(cells[3])});
  }
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

std::string joined(const std::vector<std::string>& spaces) {
  std::string all;
  for (const std::string& space : spaces) all += (all.empty() ? "" : "::") + space;
  return all;
}

/// The names that a header declares for its users: in `tumble` and the namespaces in it, but for
/// `detail`.
NamesBySpace public_names_in(const std::string& header) {
  static const std::regex opened(R"(^namespace ([\w:]+) \{$)"), closed(R"(^\}  // namespace)"),
      for_users(R"(^tumble\b(?!.*\bdetail\b))");
  std::vector<std::string> spaces;
  NamesBySpace names;
  std::smatch found;
  for (const std::string& line : lines_of(header)) {
    if (std::regex_search(line, found, opened)) spaces.push_back(found[1]);
    if (std::regex_search(line, closed)) spaces.pop_back();
    const bool at_margin = !line.empty() && std::string(" /#}").find(line[0]) == std::string::npos;
    if (!at_margin || !std::regex_search(joined(spaces), for_users)) continue;
    if (const std::string name = declared_by(line); !name.empty())
      names[joined(spaces)].insert(name);
  }
  return names;
}

using Headers = std::map<std::string, NamesBySpace>;

/// The names of a row that none of its headers declares, a sentence each.
std::vector<std::string> undeclared(const Row& row, const Headers& headers) {
  Names declared;
  for (const std::string& header : row.headers)
    if (const auto all = headers.find(header); all != headers.end())
      if (const auto names = all->second.find(row.space); names != all->second.end())
        declared.insert(names->second.begin(), names->second.end());
  std::vector<std::string> found;
  for (const std::string& name : row.names)
    if (!declared.count(name))
      found.push_back("lib/README.md lists " + row.space + "::" + name + ", which none of " +
                      *row.headers.begin() + " … declares");
  return found;
}

/// Everything in which the tables and the headers differ, a sentence each.
std::vector<std::string> differences(const std::vector<Row>& tables, const Headers& headers) {
  std::vector<std::string> found;
  NamesBySpace listed;
  for (const Row& row : tables) {
    const auto missing = undeclared(row, headers);
    found.insert(found.end(), missing.begin(), missing.end());
    listed[row.space].insert(row.names.begin(), row.names.end());
  }
  for (const auto& [header, spaces] : headers)
    for (const auto& [space, names] : spaces)
      for (const std::string& name : names)
        if (!listed[space].count(name))
          found.push_back(header + " declares " + space + "::" + name +
                          ": list it in lib/README.md, or move it to detail");
  return found;
}

Headers headers_below(const fs::path& folder) {
  Headers headers;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.path().extension() == ".hpp")
      headers[fs::relative(entry.path(), folder).generic_string()] =
          public_names_in(text_of(entry.path()));
  return headers;
}

/// All names of a namespace, of whichever header.
Names names_of(const std::string& space, const Headers& headers) {
  Names all;
  for (const auto& [header, spaces] : headers)
    if (const auto names = spaces.find(space); names != spaces.end())
      all.insert(names->second.begin(), names->second.end());
  return all;
}

/// The headers that a program gets which includes `header`, if the bodies are compiled elsewhere
/// (`tumble::compiled`): without those in `.inl` files.
void add_reached(const fs::path& folder, const std::string& header, Names& reached) {
  if (!reached.insert(header).second) return;
  static const std::regex include(R"re(#include "tumble/(.*\.hpp)")re");
  std::smatch found;
  for (const std::string& line : lines_of(text_of(folder / header)))
    if (std::regex_search(line, found, include)) add_reached(folder, found[1], reached);
}

fs::path project_root() {
  const char* root = std::getenv("TUMBLE_ROOT");
  REQUIRE_MESSAGE(root != nullptr, "TUMBLE_ROOT is not set");
  return root;
}

}  // namespace

TEST_SUITE("public names") {
  TEST_CASE("the tables of lib/README.md list what the headers declare for users") {
    const auto tables = tables_in(text_of(project_root() / "lib/README.md"));
    const Headers headers = headers_below(project_root() / "lib/include/tumble");
    CHECK(tables.size() > 50);  // both were read
    CHECK(headers.at("body/dydt.hpp") == NamesBySpace{{"tumble", {"RigidBodyRhs"}}});
    CHECK(headers.at("ode/euler.hpp") ==
          NamesBySpace{{"tumble::runge_kutta", {"Euler", "euler_step"}}});
    for (const std::string& difference : differences(tables, headers)) FAIL_CHECK(difference);
  }

  TEST_CASE(
      "the umbrella headers bring every public name, also where the bodies are compiled once") {
    Names reached;
    for (const char* umbrella : {"tumble.hpp", "collide.hpp", "contact.hpp"})
      add_reached(project_root() / "lib/include/tumble", umbrella, reached);
    CHECK(reached.count("core/types.hpp") == 1);
    for (const Row& row : tables_in(text_of(project_root() / "lib/README.md")))
      for (const std::string& header : row.headers)
        CHECK_MESSAGE(reached.count(header) == 1, header << " is in no umbrella header");
  }

  TEST_CASE("namespace tumble itself holds what a program needs: 135 names at most") {
    const Headers headers = headers_below(project_root() / "lib/include/tumble");
    const std::size_t count = names_of("tumble", headers).size();
    CHECK(count > 100);
    CHECK(count <= 135);
  }

  TEST_CASE("each kind of declaration is seen, and what is inside of something else is not") {
    const NamesBySpace names = public_names_in(R"(#pragma once
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
namespace tumble::topic {
struct Elsewhere {};
}  // namespace tumble::topic
namespace tumble::detail::topic {
struct Hidden {};
}  // namespace tumble::detail::topic
namespace Eigen {
struct Foreign {};
}  // namespace Eigen
)");
    CHECK(names == NamesBySpace{{"tumble",
                                 {"Plain", "Constrained", "Kind", "Alias", "Good", "constant",
                                  "function", "reference"}},
                                {"tumble::topic", {"Elsewhere"}}});
  }

  TEST_CASE("a name too many is found, on either side, and in the wrong namespace") {
    const std::vector<Row> tables{{"tumble", {"one", "two"}, {"a.hpp"}}};
    CHECK(differences(tables, {{"a.hpp", {{"tumble", {"one", "two"}}}}}).empty());
    CHECK(differences(tables, {{"a.hpp", {{"tumble", {"one"}}}}}).size() == 1);
    CHECK(differences(tables, {{"a.hpp", {{"tumble", {"one", "two", "three"}}}}}).size() == 1);
    CHECK(differences(tables, {{"a.hpp", {{"tumble", {"one"}}}}, {"b.hpp", {{"tumble", {"two"}}}}})
              .size() == 1);
    CHECK(differences(tables, {{"a.hpp", {{"tumble", {"one"}}, {"tumble::topic", {"two"}}}}})
              .size() == 2);
  }

  TEST_CASE("names are counted by namespace, over all headers, once each") {
    const Headers headers{{"a.hpp", {{"tumble", {"one"}}, {"tumble::topic", {"two"}}}},
                          {"b.hpp", {{"tumble", {"one", "three"}}}}};
    CHECK(names_of("tumble", headers) == Names{"one", "three"});
    CHECK(names_of("tumble::topic", headers) == Names{"two"});
  }

  TEST_CASE("the tables are read below their heading only, with the namespace of the rows above") {
    const auto tables = tables_in(
        "| a | `x` | `x.hpp` |\n## Names\n| a | `y` `z` | `y.hpp` |\ntext\n"
        "| `tumble::b`: what | `u` | `u.hpp` |\n| | `v` | `v.hpp` |\n");
    REQUIRE(tables.size() == 3);
    CHECK(tables[0].space == "tumble");
    CHECK(tables[0].names == Names{"y", "z"});
    CHECK(tables[0].headers == Names{"y.hpp"});
    CHECK(tables[1].space == "tumble::b");
    CHECK(tables[2].space == "tumble::b");
    CHECK(tables[2].names == Names{"v"});
  }
}
