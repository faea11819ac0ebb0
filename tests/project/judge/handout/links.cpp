/// @file
/// What is handed out: which chapters are meant, and pages without dead links.
#include <doctest/doctest.h>

#include "judge/handout/dead_links.hpp"
#include "judge/handout/handout.hpp"
#include "project/harness/refusal.hpp"

using namespace tumble::judge;

namespace {

Course small_course() {
  Course course;
  for (const char* chapter : {"01_particles", "02_solvers", "04_quaternions"})
    course.units.push_back(
        {std::to_string(chapter[1] - '0') + ".1", chapter, "unit", {}, {}, "solution.o"});
  return course;
}

std::string linked(const std::string& text) {
  std::string page =
      without_dead_links(text, "chapters/02_solvers/README.md",
                         {"chapters/02_solvers/README.md", "chapters/02_solvers/figures/a.svg",
                          "lib/include/tumble/ode/rk4.hpp", "LICENSE"});
  page.pop_back();  // the last line is ended, too
  return page;
}

}  // namespace

TEST_CASE("hand-out: 1-2 and 4 are chapters, other texts are not") {
  using Names = std::set<std::string>;
  CHECK(chapters_meant(small_course(), "1-2") == Names{"01_particles", "02_solvers"});
  CHECK(chapters_meant(small_course(), "4,1") == Names{"01_particles", "04_quaternions"});
  for (const char* text : {"1 – 2", "1–2", " 1 - 2 ", "1 , 2"})
    CHECK(chapters_meant(small_course(), text) == Names{"01_particles", "02_solvers"});
  CHECK_REFUSED(chapters_meant(small_course(), "1-4"), "no exercise or chapter '3'");
  CHECK_REFUSED(chapters_meant(small_course(), "2-1"), "ends before it begins");
  for (const char* text : {"", "a", "1-", "1,,2", "1-2-3", "all", "99999999999"})
    CHECK_REFUSED(chapters_meant(small_course(), text), "is neither a chapter nor a range");
}

TEST_CASE("hand-out: links to what is not there leave their words behind") {
  CHECK(linked("see [chapter 4](../04_quaternions/README.md), or [this](#here)") ==
        "see chapter 4, or [this](#here)");
  CHECK(linked("[`rk4`](../../lib/include/tumble/ode/rk4.hpp) [`x`](../../lib/x.hpp)") ==
        "[`rk4`](../../lib/include/tumble/ode/rk4.hpp) `x`");
  CHECK(
      linked("![A figure.](figures/a.svg) [lib](../../lib/) [ode](../../lib/include/tumble/ode)") ==
      "![A figure.](figures/a.svg) [lib](../../lib/) [ode](../../lib/include/tumble/ode)");
  CHECK(linked("[far](https://example.org/a) [near](b.md)") == "[far](https://example.org/a) near");
  CHECK(linked("```cpp\nf[i](x);\n```\n[i](x)") == "```cpp\nf[i](x);\n```\ni");
  CHECK(linked("> ```cpp\n> f[i](x);\n> ```\n> [i](x)") == "> ```cpp\n> f[i](x);\n> ```\n> i");
}

TEST_CASE("hand-out: rows, items and parts of a line about what is not there are left out") {
  CHECK(linked("|---|---|\n| [`x/`](x/README.md) | gone |\n| [a](figures/a.svg) | here |") ==
        "|---|---|\n| [a](figures/a.svg) | here |");
  CHECK(linked("- [x](x.md) is\n  gone, as\n  a whole\n- [a](figures/a.svg) stays\n\nwords") ==
        "- [a](figures/a.svg) stays\n\nwords");
  CHECK(linked("- words, then [x](x.md)") == "- words, then x");
  CHECK(linked("[a](#a) · [x](x.md) · [b](#b)") == "[a](#a) · [b](#b)");
  CHECK(linked("[x](x.md) · [a](#a) ·\n[y](y.md)") == "[a](#a)");
  CHECK(linked("[a](#a): words · [x](x.md)") == "[a](#a): words");
  CHECK(linked("```\n| [x](x.md) | code |\n```") == "```\n| [x](x.md) | code |\n```");
}

TEST_CASE("hand-out: nothing is overwritten") {
  CHECK_REFUSED(make_tree(small_course(), {{"01_particles"}}, "/usr"), "/usr exists already");
}
