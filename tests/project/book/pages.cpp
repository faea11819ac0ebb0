/// @file
/// What is wrong with a page is found, and said with its line: each case breaks one thing in a book
/// of one chapter that is right otherwise.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "book/tool/check.hpp"
#include "project/harness/temporary_folder.hpp"

using namespace tumble::book;

namespace {

/// A book of one chapter.
class SmallBook : public tumble::test::TemporaryFolder {
 public:
  SmallBook() {
    write("README.md", "# Front\n\nYou read [one](chapters/01_one/README.md).\n");
    write("chapters/book/pages_to_rewrite.txt", "# a list\nchapters/01_one/README.md\n");
    write("chapters/terms/README.md", text_of(fresh_terms(path())));
    write("exercises/01_one/contract.hpp",
          "// == 1.1 twice: a number doubled\n/// @return 2x\nint twice(int x);\n");
    write("exercises/01_one/hints.md", "## 1.1 twice\n\n1. Add it\n   to itself.\n2. x + x\n");
    write("code.hpp", "/// Twice as much.\nint twice(int x) {\n  return x + x;\n}\n");
    write("chapters/01_one/figures/a.svg", "<svg/>\n");
    write("programs/01_one",
          "#!/bin/sh\n[ \"$2\" = times ] && echo 'sum  3 ns' || echo 'drift  1.5'\n");
    fs::permissions(path() / "programs/01_one", fs::perms::owner_all);
  }

  static std::string text_of(const Page& page) {
    std::string text;
    for (const std::string& line : page.lines) text += line + "\n";
    return text;
  }

  Places places() const { return {path(), path() / "programs"}; }
  fs::path chapter() const { return path() / "chapters/01_one/README.md"; }

  /// What is wrong if the chapter's page has this text below its heading, at line 3.
  std::string mistakes(const std::string& text) const {
    write("chapters/01_one/README.md", "# One\n\n" + text);
    std::string all;
    for (const std::string& mistake : mistakes_in(places())) all += mistake + "\n";
    return all;
  }
};

std::string fence(const std::string& announcement, const std::string& language,
                  const std::string& content) {
  return "<!-- " + announcement + " -->\n```" + language + "\n" + content + "```\n";
}

const std::string twice = "int twice(int x) {\n  return x + x;\n}\n";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a page that is right has no mistakes") {
  const SmallBook book;
  CHECK(book.mistakes(fence("snippet: code.hpp#twice", "cpp", twice) +
                      fence("snippet: code.hpp#*", "cpp", twice) +
                      fence("signature: code.hpp#twice", "cpp", "int twice(int x);\n") +
                      fence("output: 01_one#drift", "text", "drift  1.5\n") +
                      "It is $x^2$, or $`\\frac{1}{2}\\,x`$.\n\n```math\nx = y\n```\n\n"
                      "![A drawing](figures/a.svg)\n\n[Up](../../README.md#front), $5 or $6.\n") ==
        "");
}

TEST_CASE("code that has changed in the source, or is not there") {
  const SmallBook book;
  const std::string stale = book.mistakes(
      fence("snippet: code.hpp#twice", "cpp", "int twice(int x) { return 2 * x; }\n"));
  CHECK(contains(stale, "01_one/README.md:4: code.hpp#twice has changed"));
  CHECK(contains(book.mistakes(fence("snippet: code.hpp#thrice", "cpp", twice)), "thrice"));
  CHECK(contains(book.mistakes(fence("snippet: none.hpp#twice", "cpp", twice)), "none.hpp"));
}

TEST_CASE("numbers that the program does not print") {
  const SmallBook book;
  CHECK(contains(book.mistakes(fence("output: 01_one#drift", "text", "drift  1.6\n")),
                 "01_one#drift has changed"));
  CHECK(contains(book.mistakes(fence("output: 02_two#drift", "text", "drift  1.6\n")), "fails"));
}

TEST_CASE("times may be others, but neither the words nor the counts") {
  const SmallBook book;
  book.write("programs/01_one", "#!/bin/sh\necho 'sum  3 ns  1.5 ×  400'\n");
  CHECK(book.mistakes(fence("measured: 01_one#times", "text", "sum  7 µs  9 ×  400\n")) == "");
  CHECK(contains(book.mistakes(fence("measured: 01_one#times", "text", "sum  3 ns  1.5 ×  401\n")),
                 "has changed"));
  book.write("programs/01_one", "#!/bin/sh\necho 'sum  3 ns'\n");
  CHECK(book.mistakes(fence("measured: 01_one#times", "text", "sum  17.5 µs\n")) == "");
  CHECK(contains(book.mistakes(fence("measured: 01_one#times", "text", "mean  3 ns\n")),
                 "has changed"));
}

TEST_CASE("ways to go wrong that the judge no longer counts so") {
  const SmallBook book;
  const std::string head = "| exercise | ways that the judge knows by name |\n|---|---|\n";
  const std::string other = "\n| 1.1 | 7 |\n";
  CHECK(book.mistakes(head + "| 1.1 | 9 |\n" + other) == "");  // nothing lists them here
  book.write("chapters/for_instructors/what_students_get_wrong.md",
             "# List\n\n### 1.1 `twice`\n\n- *thrice*: You have.\n- *once*: You have not.\n");
  CHECK(book.mistakes(head + "| 1.1 | 2 |\n" + other) == "");
  CHECK(contains(book.mistakes(head + "| 1.1 | 9 |\n" + other), ":5: the judge knows another"));
}

TEST_CASE("code and output that nothing keeps true") {
  const SmallBook book;
  CHECK(contains(book.mistakes("```cpp\nint x;\n```\n"), ":3: nothing says where this comes from"));
  CHECK(contains(book.mistakes("```text\n3\n```\n"), "nothing says where"));
  CHECK(contains(book.mistakes(fence("outptu: 01_one#drift", "text", "drift  1.5\n")),
                 ":3: a fence is announced by"));
  CHECK(contains(book.mistakes("<!-- output: 01_one#drift -->\ntext\n"), "expects a ``` fence"));
  CHECK(contains(book.mistakes("```sh\nls\n"), "not closed"));
  CHECK(contains(book.mistakes("```c++\nint x;\n```\n"), "nothing says where"));
  CHECK(contains(book.mistakes("   ```cpp\n   int x;\n   ```\n"), "in the first column"));
  CHECK(contains(book.mistakes("<!-- output: 01_one -->\n```text\n```\n"), "path#name"));
  CHECK(contains(book.mistakes("<!-- a note\n-->\n"), ":3: a comment ends in its line"));
  CHECK(contains(book.mistakes("<!-- a note -->\n" + fence("output: 01_one#drift", "sh", "ls\n")),
                 "has changed"));
}

TEST_CASE("a fence that is closed badly does not swallow what follows") {
  const SmallBook book;
  const std::string next = "Precious.\n\n" + fence("output: 01_one#drift", "text", "drift  1.5\n");
  CHECK(contains(book.mistakes("<!-- output: 01_one#drift -->\n```text\ndrift\n" + next),
                 "a fence within the one of line 4"));
  CHECK(contains(book.mistakes("```sh\nls\n``` \n" + next), ":5: a fence within"));
}

TEST_CASE("a table that would be cut off") {
  const SmallBook book;
  book.write("programs/01_one", "#!/bin/sh\nprintf '%098d\\n' 1\n");
  const std::string row = std::string(97, '0') + "1\n";
  CHECK(contains(book.mistakes(fence("output: 01_one#drift", "text", row)),
                 ":4: this table is 98 characters wide"));
}

TEST_CASE("a row of a table with another number of cells than its heading") {
  const SmallBook book;
  CHECK(book.mistakes("| a | b |\n|---|---|\n| \\|x\\| | `c \\| d` |\n").empty());
  CHECK(contains(book.mistakes("| a | b |\n|---|---|\n| |x| | c |\n"),
                 "this row has 4 cells, and its heading has 2"));
}

TEST_CASE("links, headings and figures that are not there") {
  const SmallBook book;
  CHECK(contains(book.mistakes("See [two](../02_two/README.md).\n"),
                 ":3: there is no ../02_two/README.md"));
  CHECK(contains(book.mistakes("See [below](#below).\n"), "there is no heading #below"));
  CHECK(contains(book.mistakes("![A drawing](figures/b.svg)\n"), "there is no figures/b.svg"));
  CHECK(contains(book.mistakes("Here: ![A drawing](figures/a.svg)\n"), "a line of its own"));
  CHECK(contains(book.mistakes("See [two\nand more](none.md).\n"),
                 ":4: a link has to be in one line"));
  CHECK(contains(book.mistakes("<img src=\"figures/a.svg\">\n"), "is written as"));
  CHECK(contains(book.mistakes("Set `$HOME` and see [two](none.md).\n"), "there is no none.md"));
}

TEST_CASE("formulas that cannot be set, or that Markdown would change") {
  const SmallBook book;
  CHECK(contains(book.mistakes("$\\foo$\n"), ":3: unknown command \\foo"));
  CHECK(contains(book.mistakes("$\\frac{1{2}$\n"), "a { without a }"));
  CHECK(contains(book.mistakes("```math\n\\begin{aligned} x\n```\n"), "is not closed"));
  for (const char* bad : {"\\frac{1}", "x^2^3", "x_", "a & b", "\\sqrt", "{x^}", "\\left"})
    CHECK_MESSAGE(contains(book.mistakes(std::string("$`") + bad + "`$\n"), ":3: "), bad);
  for (const char* good : {"x_i^2", "x^{a^b}", "\\sqrt[3]{x}", "\\frac12", "\\left( x \\right]"})
    CHECK_MESSAGE(book.mistakes(std::string("$`") + good + "`$\n") == "", good);
  CHECK(contains(book.mistakes("$a\\,b$\n"), "Markdown changes \\,"));
  CHECK(contains(book.mistakes("$x^2 open\n"), ":3: this $ has no partner"));
  CHECK(contains(book.mistakes("A `\\` and $\\foo$.\n"), "unknown command \\foo"));
  CHECK(contains(book.mistakes("$\\dot{x}_i$ and $y_i$\n"), "Markdown changes }_"));
  CHECK(contains(book.mistakes("| a |\n|---|\n| $|x|$ |\n"), ":5: | ends the cell"));
}

TEST_CASE("writing takes over what has changed, and nothing else") {
  const SmallBook book;
  const std::string before = "Text.\n\n" + fence("output: 01_one#drift", "text", "old\nolder\n") +
                             "\nMore.\n" + fence("snippet: code.hpp#twice", "cpp", "");
  CHECK(book.mistakes(before) != "");
  write_page(refreshed(book.places(), read_page(book.chapter())));
  std::ifstream in(book.chapter());
  CHECK(std::string(std::istreambuf_iterator<char>(in), {}) ==
        "# One\n\nText.\n\n" + fence("output: 01_one#drift", "text", "drift  1.5\n") + "\nMore.\n" +
            fence("snippet: code.hpp#twice", "cpp", twice));
}

TEST_CASE("if one page cannot be refreshed, its fence is named and no page is lost") {
  const SmallBook book;
  book.mistakes("Text.\n\n" + fence("output: 01_one#drift", "text", "old\n"));
  book.write("programs/01_one", "#!/bin/sh\nexit 3\n");
  const Page page = read_page(book.chapter());
  CHECK_THROWS_WITH_AS(refreshed(book.places(), page), doctest::Contains("README.md:6: "),
                       PageError);
  CHECK_THROWS_WITH(refreshed(book.places(), page), doctest::Contains("status 3"));
}

TEST_CASE("a signature keeps its default arguments") {
  const SmallBook book;
  book.write("code.hpp", "int scaled(int x, int by = 3, Way way = {}) {\n  return x * by;\n}\n");
  CHECK(book.mistakes(fence("signature: code.hpp#scaled", "cpp",
                            "int scaled(int x, int by = 3, Way way = {});\n")) == "");
}
