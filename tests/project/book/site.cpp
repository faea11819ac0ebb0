/// @file
/// What Doxygen is given for a page.
#include "book/tool/site.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "project/harness/refusal.hpp"
#include "project/harness/temporary_folder.hpp"

using namespace tumble::book;
using tumble::test::mentions;

namespace {

/// A project of one page.
class Project : public tumble::test::TemporaryFolder {
 public:
  Project() {
    write("README.md", "# Front\n");
    write("chapters/02_two/README.md", "# Two\n");
    write("chapters/01_one/figures/a.svg", "<svg>drawn</svg>");
  }

  /// What becomes of this text in a chapter's page.
  std::string converted(const std::string& text) const {
    write("chapters/01_one/README.md", text);
    return for_doxygen(path(), read_page(path() / "chapters/01_one/README.md"));
  }
};

}  // namespace

TEST_CASE("every line of the page has one line in the site, so that Doxygen's line numbers hold") {
  const Project project;
  const std::string page = "# One\n\n## A part\n\n```math\nx\n```\n\n![A](figures/a.svg)\n";
  const std::string site = project.converted(page);
  CHECK(std::count(site.begin(), site.end(), '\n') == std::count(page.begin(), page.end(), '\n'));
}

TEST_CASE("headings have names, and links lead to them") {
  const Project project;
  CHECK(mentions(project.converted("# One\n\n## What it costs\n"), "# One {#chapters-01_one}",
                 "## What it costs {#chapters-01_one-what-it-costs}"));
  CHECK(mentions(project.converted("See [two](../02_two/README.md) and [below](#costs).\n"),
                 "[two](@ref chapters-02_two)", "[below](@ref chapters-01_one-costs)"));
  CHECK(project.converted("[code](../../lib/a.cpp)\n") == "code\n");
  CHECK(project.converted("[far](https://a.b/c)\n") == "[far](https://a.b/c)\n");
}

TEST_CASE("formulas are set, and code and dollars are not") {
  const Project project;
  CHECK(project.converted("$x^2$ and $`a\\,b`$\n") == "\\f$x^2\\f$ and \\f$a\\,b\\f$\n");
  CHECK(project.converted("`$x$` for $5 or $6\n") == "`$x$` for $5 or $6\n");
  CHECK(project.converted("```math\nx\n```\n") == "\\f[\nx\n\\f]\n");
  CHECK(project.converted("```sh\n$x$\n```\n") == "```sh\n$x$\n```\n");
}

TEST_CASE("the paragraph in italics below a figure becomes its caption") {
  const Project project;
  const std::string site = project.converted(
      "![read out](figures/a.svg)\n\n*Figure 1.1. How $x$\nfalls, by `f`.*\n\nText.\n");
  CHECK(
      mentions(site, "<figcaption>Figure 1.1. How \\(x\\) falls, by <code>f</code>.</figcaption>"));
  CHECK_FALSE(mentions(site, "read out"));
  CHECK_FALSE(mentions(site, "*Figure"));
  CHECK(std::count(site.begin(), site.end(), '\n') == 6);
}

TEST_CASE("a box is a division with its content unquoted, and other quotations stay") {
  const Project project;
  const std::string site = project.converted(
      "Text.\n\n> **Try it.** What is $x$?\n>\n> ```sh\n> ls\n> ```\n\n> A quotation.\n");
  CHECK(site ==
        "Text.\n\\htmlonly[block] <div class=\"try-it\"> \\endhtmlonly\n**Try it.** What is "
        "\\f$x\\f$?\n\n```sh\nls\n```\n\\htmlonly[block] </div> \\endhtmlonly\n> A quotation.\n");
  CHECK_THROWS_WITH(project.converted("Text.\n> **Try it.** What?\n"),
                    doctest::Contains("line above a box is empty"));
  CHECK_THROWS_WITH(project.converted("\n> **Try it.** What?\nText.\n"),
                    doctest::Contains("line below a box is empty"));
}

TEST_CASE("two boxes below each other are two") {
  const Project project;
  const std::string site =
      project.converted("Text.\n\n> **Try it.** What?\n\n> **For the curious.** Why?\n\nText.\n");
  CHECK(mentions(site,
                 "What?\n\\htmlonly[block] </div><div class=\"curious\"> \\endhtmlonly\n**For"));
}

TEST_CASE("a second page of a chapter has a name of its own") {
  CHECK(page_id("/p", "/p/chapters/08_eight/README.md") == "chapters-08_eight");
  CHECK(page_id("/p", "/p/chapters/08_eight/digits.md") == "chapters-08_eight-digits");
}

TEST_CASE("a figure's place is kept, and the drawing is put there when Doxygen is through") {
  const Project project;
  const std::string site = project.converted("![How $x$ falls.](figures/a.svg)\n");
  CHECK(mentions(site, "<figure>", "<figcaption>How \\(x\\) falls.</figcaption>"));
  CHECK(mentions(project.converted("![If $a<b$ & c.](figures/a.svg)\n"),
                 "<figcaption>If \\(a&lt;b\\) &amp; c.</figcaption>"));
  project.write("html/page.html", "before " + site + " after");
  fill_in_figures(project.path(), project.path() / "html");
  std::ifstream in(project.path() / "html/page.html");
  const std::string page{std::istreambuf_iterator<char>(in), {}};
  CHECK(mentions(page, "before", "<svg>drawn</svg>", "after"));
  CHECK_FALSE(mentions(page, "data-figure"));
}
