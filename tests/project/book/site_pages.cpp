/// @file
/// Which pages the site has beside the book's, and that its links lead somewhere.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "book/tool/contract.hpp"
#include "book/tool/dead_ends.hpp"
#include "book/tool/exercise_pages.hpp"
#include "book/tool/html.hpp"
#include "book/tool/page_numbers.hpp"
#include "book/tool/prepare.hpp"
#include "book/tool/printed.hpp"
#include "book/tool/reference_links.hpp"
#include "book/tool/search_index.hpp"
#include "book/tool/sidebar.hpp"
#include "book/tool/site_files.hpp"
#include "project/harness/refusal.hpp"
#include "project/harness/temporary_folder.hpp"
#include "support/text_file.hpp"

using namespace tumble::book;
using tumble::test::mentions;

namespace {

/// A project of one chapter with one exercise.
class SmallProject : public tumble::test::TemporaryFolder {
 public:
  SmallProject() {
    write("README.md", "# Front\n\nYou read [one](chapters/01_one/README.md), [news](NEWS.md).\n");
    write("NEWS.md", "# News\n\nSee [more](more/README.md).\n");
    write("more/README.md", "# More\n\n[back](../NEWS.md), [a list](../lib/list.txt)\n");
    write("lib/list.txt", "a\nb\n");
    write("lib/README.md",
          "# The library\n\n| `…` | holds |\n|---|---|\n| `core/` | small types |\n");
    write("lib/include/tumble/core/a.hpp", "");
    write("lib/include/tumble/tumble.hpp", "/// @defgroup small_types Small types\n");
    write("chapters/01_one/README.md",
          "# 1 One\n\nFirst.\n\n## Twice\n\nA **double** is `x` + `x`, or $\\omega$.\n\n"
          "<!-- exercise: 1.1 -->\n\n[contract](../../exercises/01_one/contract.hpp) "
          "[solutions](../../solutions/01_one)\n");
    write("exercises/01_one/contract.hpp",
          "#pragma once\n/// @file\n/// Chapter 1: what you write.\n///\n/// You may use Eigen.\n\n"
          "namespace one {\n\n/// A pair.\nstruct Pair {};\n\n"
          "// == 1.1 twice: a number doubled\n/// Two of them.\n/// @param x, y any numbers,\n"
          "///             also none\n/// @return 2x\nint twice(int x, int y);\n\n}  // namespace "
          "one\n");
    write("exercises/01_one/hints.md",
          "## 1.1 twice\n\n1. Add it\n   to itself.\n2. x + x\n3. Return it.\n");
    write("solutions/01_one/twice.cpp", "/// @file\n/// It doubles.\nint twice(int x);\n");
  }
};

std::string text_of_page(const Page& page) {
  std::string text;
  for (const std::string& line : page.lines) text += line + "\n";
  return text;
}

}  // namespace

TEST_CASE("the site holds all that its pages lead to, each once") {
  const SmallProject project;
  const SiteFiles files = site_files(project.path());
  const fs::path root = fs::canonical(project.path());
  CHECK(files.pages == std::vector<fs::path>{root / "README.md", root / "chapters/01_one/README.md",
                                             root / "lib/README.md", root / "NEWS.md",
                                             root / "more/README.md"});
  CHECK(files.exercises == std::vector<fs::path>{root / "exercises/01_one"});
  CHECK(files.shown == std::vector<fs::path>{root / "solutions/01_one", root / "lib/list.txt"});
}

TEST_CASE(
    "a task that begins with a list keeps its first item, and a text goes on behind the title") {
  const SmallProject project;
  const auto page_with = [&project](const std::string& task) {
    project.write("exercises/01_one/contract.hpp",
                  "#pragma once\n/// @file\n/// Chapter 1.\n\n// == 1.1 twice: a number doubled\n" +
                      task + "int twice(int x);\n");
    return text_of_page(exercise_page(project.path(), project.path() / "exercises/01_one"));
  };
  CHECK(mentions(page_with("/// - One.\n/// - Two.\n"), "**A number doubled.**\n\n- One.\n- Two."));
  CHECK(mentions(page_with("/// Two of them.\n"), "**A number doubled.** Two of them."));
}

TEST_CASE("a contract is its introduction, what is given, and its exercises") {
  const SmallProject project;
  const Contract contract = read_contract(project.path() / "exercises/01_one/contract.hpp");
  CHECK(contract.introduction == "\nYou may use Eigen.\n");
  CHECK(contract.types == "/// A pair.\nstruct Pair {};\n");
  REQUIRE(contract.parts.size() == 1);
  CHECK(contract.parts[0].number == "1.1");
  CHECK(contract.parts[0].task ==
        "Two of them.\n\n- `x`, `y`: any numbers,\n  also none\n- returns 2x\n");
  CHECK(contract.parts[0].code == "int twice(int x, int y);\n");
  CHECK(hints_of(project.path() / "exercises/01_one/hints.md", "1.1") ==
        std::vector<Hint>{{"Add it", "to itself."}, {"x + x"}, {"Return it."}});
}

TEST_CASE("a contract's own list and that of its parameters are two") {
  CHECK(markdown_of_comment({"They are", "- a weight;", "- drag, against", "  the way.", "",
                             "@param x a place", "@return a rate"}) ==
        "They are\n- a weight;\n- drag, against\nthe way.\n\nWhat it takes and gives:\n\n"
        "- `x`: a place\n- returns a rate\n");
}

TEST_CASE("the page of a chapter's exercises: each hint is inside the one before") {
  const SmallProject project;
  const std::string page =
      text_of_page(exercise_page(project.path(), project.path() / "exercises/01_one"));
  CHECK(mentions(page, "# Exercises: 1 One", "## 1.1 twice", "**A number doubled.** Two of them."));
  CHECK(mentions(page, "[Twice](../../chapters/01_one/README.md#twice)",
                 "[a solution](../../solutions/01_one#twicecpp)"));
  CHECK_FALSE(mentions(page, "specification"));  // there is none
  const auto first = page.find("to itself."), second = page.find("x + x");
  CHECK(page.substr(first, second - first).find("</details>") == std::string::npos);
}

TEST_CASE("what is prepared for Doxygen: pages, their order, and the list beside them") {
  const SmallProject project;
  project.write("theme/header.html", "<nav><!-- all pages --></nav>");
  const fs::path site = project.path() / "site";
  prepare_site(project.path(), project.path() / "theme", site);
  CHECK(mentions(text_of(site / "header.html"), "<a href=\"chapters-01_one.html\">1 One</a>",
                 "<a href=\"exercises-01_one.html\">exercises</a>",
                 "<a href=\"group__small__types.html\">Small types</a>"));
  CHECK(mentions(text_of(site / "pages/solutions-01_one.markdown"), "twice.cpp", "It doubles.",
                 "int twice(int x);"));
  CHECK(mentions(text_of(site / "pages/lib-list_txt.markdown"), "# lib/list.txt", "a\nb\n"));
  CHECK(mentions(text_of(site / "pages/folders.dox"), "core\n\\brief small types */"));
  const std::string inputs = text_of(site / "inputs.doxy");
  CHECK(inputs.find("/chapters/01_one/README.md") < inputs.find("/NEWS.md"));
  project.write("theme/header.html", "<nav></nav>");
  CHECK_THROWS_WITH(prepare_site(project.path(), project.path() / "theme", site),
                    doctest::Contains("has no <!-- all pages -->"));
}

TEST_CASE("links that lead nowhere: to no file, and to no place in a file") {
  const tumble::test::TemporaryFolder site;
  site.write("a.html",
             "<a href=\"b.html#there\">1</a><a href=\"#here\">2</a><p id=\"here\"></p>"
             "<a href=\"https://a.b/c\">3</a><a href=\"mailto:a@b\">4</a>"
             "<img src=\"x%20y.svg\"/>");
  site.write("b.html",
             "<h1 id=\"there\">B</h1><a name=\"old\"></a><a href=\"a.html\"></a>"
             "<a href=\"#old\"></a>");
  site.write("x y.svg", "");
  CHECK(dead_ends(site.path()).empty());
  site.write("c.html",
             "<a href=\"d.html\">1</a><a href=\"a.html#gone\">2</a>"
             "<a href=\"#nowhere\">3</a><img src=\"none.png\"/>");
  CHECK(dead_ends(site.path()) == std::vector<std::string>{"c.html: #nowhere",
                                                           "c.html: a.html#gone", "c.html: d.html",
                                                           "c.html: none.png"});
}

TEST_CASE("the search knows headings, terms, text and names") {
  const SmallProject project;
  const std::vector<Entry> entries =
      entries_of(project.path(), read_page(project.path() / "chapters/01_one/README.md"));
  REQUIRE(entries.size() == 2);
  CHECK(entries[0].address == "chapters-01_one.html");
  CHECK(entries[0].text == "First. ");
  CHECK(entries[1].address == "chapters-01_one.html#chapters-01_one-twice");
  CHECK(entries[1].section == "Twice");
  CHECK(entries[1].terms == "double, ");
  CHECK(mentions(entries[1].text, "A double is x + x, or omega."));
  CHECK(script_of({{"a", "b \"c\"", "", "", "d\\e"}}) ==
        "// Written by the book's tool: [address, page, section, terms, text].\n"
        "const tumbleIndex = [\n[\"a\",\"b \\\"c\\\"\",\"\",\"\",\"d\\\\e\"],\n];\n");
}

TEST_CASE("the names of the library's page lead to their reference, each in its namespace") {
  const std::vector<Entry> names{{"a.html", "Reference", "tumble::pack", "", ""},
                                 {"b.html", "Reference", "tumble::rotation::pack", "", ""}};
  CHECK(with_reference_links(
            "<code>tumble::compiled</code> <code>pack</code>, <code>more</code>; "
            "<td class=\"x\"><code><a>tumble::rotation</a></code>: <code>pack</code>.",
            names) ==
        "<code>tumble::compiled</code> <a href=\"a.html\"><code>pack</code></a>, "
        "<code>more</code>; <td class=\"x\"><code><a>tumble::rotation</a></code>: <a "
        "href=\"b.html\"><code>pack</code></a>.");
}

TEST_CASE("what is printed: unfolded, without what steers a screen, with links inside the book") {
  const std::string page =
      "<h1 class=\"title\">1 One</h1><div class=\"contents\"><nav class=\"page-contents\">x</nav>"
      "<details><a href=\"two.html\">a</a><a href=\"two.html#two-b\">b</a></details>"
      "<a href=\"group.html\">c</a><a href=\"https://d\">d</a></div><!-- contents --> rest";
  CHECK(printed_article(page, "one", {"one", "two"}) ==
        "<article id=\"one\"><h1>1 One</h1>\n<div class=\"contents\"><details open=\"open\">"
        "<a href=\"#two\">a</a><a href=\"#two-b\">b</a></details><a >c</a>"
        "<a href=\"https://d\">d</a></div></article>\n");
}

TEST_CASE("what is printed: the contents have the pages on which the PDF has their places") {
  const std::string pdf =
      "3 0 obj\n<</Type /Page\n>>\n11 0 obj\n<</Type /Page\n>>\n12 0 obj\n<</Type /Pages\n>>\n"
      "13 0 obj\n<</one [3 0 R /XYZ 0 8 0]\n/one-a#25E2#2580#2593b [11 0 R /XYZ 0 4 0]>>\n";
  const std::map<std::string, int> pages = pages_of_places(pdf);
  CHECK(pages == std::map<std::string, int>{{"one", 1}, {"one-a–b", 2}});
  const std::string html =
      "<nav><ul><li><a href=\"#one\">1</a><span>000</span></li>"
      "<li><a href=\"#one-a–b\">a</a><span>000</span></li></ul></nav><a href=\"#two\">x</a>";
  CHECK(with_page_numbers(html, pages) ==
        "<nav class=\"numbered\"><ul><li><a href=\"#one\">1</a><span>1</span></li>"
        "<li><a href=\"#one-a–b\">a</a><span>2</span></li></ul></nav><a href=\"#two\">x</a>");
  CHECK_REFUSED(with_page_numbers(html, {{"one", 1}}), "one-a");
}

TEST_CASE(
    "what is printed: the contents have the sections, also those within parts, and no deeper "
    "ones") {
  const SmallProject project;
  project.write("chapters/01_one/README.md",
                "# 1 One\n\n## First\n\n### Below\n\n## Part one: P\n\n### Inside\n\n#### Deep\n\n"
                "## Last\n\n### Below again\n");
  project.write("html/chapters-01_one.html",
                "<h1 class=\"title\">1 One</h1><div class=\"contents\">x</div><!-- contents -->");
  SiteFiles files;
  files.pages = {project.path() / "chapters/01_one/README.md"};
  write_printed_book(project.path(), files, project.path() / "html");
  const std::string text = tumble::support::read_text(project.path() / "html/print.html");
  std::string titles;
  for (std::size_t at = text.find("<nav>"), end = text.find("</nav>"); at < end;) {
    const std::size_t title = text.find("\">", text.find("<a ", at)) + 2;
    at = text.find("</a>", title);
    titles += text.substr(title, at - title) + "; ";
    at = std::min(text.find("<a ", at), end);
  }
  CHECK(titles == "1 One; First; Part one: P; Inside; Last; ");
}

TEST_CASE("the search knows the library's names, without its internals") {
  const std::string member =
      "<member kind=\"function\"><name>f</name><anchorfile>g.html</anchorfile>"
      "<anchor>a1</anchor></member>";
  const std::vector<Entry> names = names_in(
      "<compound kind=\"struct\"><name>t::Box</name><filename>box.html</filename></compound>"
      "<compound kind=\"struct\"><name>t::detail::Row</name><filename>r.html</filename></compound>"
      "<compound kind=\"namespace\"><name>t</name><filename>t.html</filename>" +
      member + member + "</compound><compound kind=\"file\"><name>f.hpp</name></compound>");
  REQUIRE(names.size() == 2);
  CHECK(names[0].section == "t::Box");
  CHECK(names[0].address == "box.html");
  CHECK(names[1].section == "t::f");
  CHECK(names[1].address == "g.html#a1");
}
