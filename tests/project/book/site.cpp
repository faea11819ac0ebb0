/// @file
/// What Doxygen is given for a page, and what becomes of its own.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "book/tool/addresses.hpp"
#include "book/tool/converter.hpp"
#include "book/tool/finish.hpp"
#include "book/tool/html.hpp"
#include "book/tool/wording.hpp"
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
                 "[two](chapters-02_two.html)",
                 "[below](chapters-01_one.html#chapters-01_one-costs)"));
  CHECK(project.converted("[code](../../lib/a.cpp)\n") == "[code](lib-a_cpp.html)\n");
  CHECK(project.converted("[all](../../solutions/01_one)\n") == "[all](solutions-01_one.html)\n");
  CHECK(project.converted("[up](../../README.md#the-chapters)\n") ==
        "[up](index.html#readme-the-chapters)\n");
  CHECK(project.converted("[a force](../../lib/include/tumble/body/forces.hpp)\n") ==
        "[a force](@ref tumble/body/forces.hpp)\n");
  CHECK(project.converted("[far](https://a.b/c)\n") == "[far](https://a.b/c)\n");
}

TEST_CASE("contract and hints are one page, and the box of an exercise leads to its place there") {
  const Project project;
  CHECK(project.converted("[hints](../../exercises/01_one/hints.md)\n") ==
        "[hints](exercises-01_one.html)\n");
  const std::string box = project.converted(
      "Text.\n\n<!-- exercise: 1.2 -->\n> **Now write 1.2: `f`.** F.\n>\n"
      "> [The contract](../../exercises/01_one/contract.hpp) says it.\n\n"
      "[All](../../exercises/01_one/contract.hpp)\n");
  CHECK(mentions(box, "[The contract](exercises-01_one.html#exercises-01_one-1.2) says it.",
                 "[All](exercises-01_one.html)"));
}

TEST_CASE("below the title are the neighbours and the contents of a page") {
  const Project project;
  const std::string site = project.converted(
      "# One\n\n## A `b`\n\n### C\n\n## D\n\n[Terms](../terms/README.md) · [2 Two "
      "→](../02_two/README.md)\n");
  CHECK(mentions(site, "## A b {#chapters-01_one-a-b}"));
  const std::string top = site.substr(0, site.find("## A"));
  CHECK(mentions(top, "<a rel=\"next\" href=\"chapters-02_two.html\">2 Two →</a>",
                 "<a href=\"chapters-terms.html\">Terms</a>",
                 "<li class=\"level2\"><a href=\"#chapters-01_one-a-b\">A <code>b</code></a></li>",
                 "<li class=\"level3\"><a href=\"#chapters-01_one-c\">C</a></li>"));
  CHECK(std::count(site.begin(), site.end(), '\n') == 9);
  CHECK(site.rfind("rel=\"next\"") > site.find("## D"));
  CHECK_FALSE(mentions(project.converted("# One\n\n## A\n\n## B\n"), "On this page"));
}

TEST_CASE("an exercise is reached from the contents of its page") {
  const Project project;
  const std::string site = project.converted(
      "# One\n\n## A\n\nText.\n\n<!-- exercise: 1.2 -->\n> **Now write 1.2: `f`.** F.\n\n## B\n\n"
      "## C\n");
  CHECK(mentions(site, "<li class=\"level3\"><a href=\"#now-write-1.2\">Now write 1.2</a></li>",
                 "<div class=\"now-write\" id=\"now-write-1.2\">"));
}

TEST_CASE("the front page's sections are not the site's") {
  const Project project;
  project.write("README.md", "# Front\n\n## The chapters\n");
  CHECK(for_doxygen(project.path(), read_page(project.path() / "README.md")) ==
        "# Front {#readme}\n\n\\htmlonly[block] <h2 id=\"readme-the-chapters\">The chapters</h2> "
        "\\endhtmlonly\n");
}

TEST_CASE("output in columns becomes a table: numbers flush right, words flush left") {
  const Project project;
  const std::string site = project.converted(
      "<!-- output: 01_one#a -->\n```text\n  method   h [s]    error\n  ──────   ─────   ──────\n"
      "  RK4 < 2   0.1   1.5e-3\n  Euler     –         2\n```\nEnd.\n");
  CHECK_FALSE(mentions(site, "<table"));  // "2" is between two columns
  const std::string table = project.converted(
      "<!-- output: 01_one#a -->\n```text\n  method   h [s]    error\n  ──────   ─────   ──────\n"
      "  a < b      0.1   1.5e-3\n  Euler        –        2\n```\nEnd.\n");
  CHECK(mentions(table, "<th class=\"words\">method</th><th>h [s]</th><th>error</th>",
                 "<td class=\"words\">a &lt; b</td><td>0.1</td><td>1.5e-\u20603</td>",
                 "<td class=\"words\">Euler</td><td>–</td><td>2</td>"));
  CHECK(std::count(table.begin(), table.end(), '\n') == 8);
  const std::string odd = project.converted(
      "<!-- output: 01_one#a -->\n```text\n  what          error    iterations\n"
      "  ───────────   ──────   ──────────\n  v_z [m/s]     < 1e-9            1\n"
      "  a word_list   exact            20\n  ω_y             2e-7        never\n```\nEnd.\n");
  CHECK(mentions(odd,
                 "<td class=\"words\">v<sub>z</sub> [m/s]</td><td>&lt; 1e-\u20609</td><td>1</td>",
                 "<td class=\"words\">a word_list</td><td>exact</td><td>20</td>",
                 "<td class=\"words\">ω<sub>y</sub></td><td>2e-\u20607</td><td>never</td>"));
  const std::string wrapped = project.converted(
      "<!-- output: 01_one#a -->\n```text\n  method   what is said\n  ──────   ────────────\n"
      "  RK4      it goes on\n           (0, 1,\n           0)\n  Euler    no\n```\nEnd.\n");
  CHECK(mentions(
      wrapped,
      "<td class=\"words\">RK4</td><td class=\"words\">it goes on (0,\u00a01,\u00a00)</td>",
      "<td class=\"words\">Euler</td><td class=\"words\">no</td>"));
  CHECK(mentions(project.converted("<!-- output: 01_one#a -->\n```text\nno table\n```\n"),
                 "```text\nno table\n```"));
}

TEST_CASE("a word that stands for numbers ends where they end, other words begin at the left") {
  const Project project;
  const std::string table = project.converted(
      "<!-- output: 01_one#a -->\n```text\n  steps   Euler      grows    verdict\n  ─────   "
      "────────   ──────   ───────\n"
      "  250     exploded   always   good\n  500     exploded   always   bad\n"
      "  1000    3          always   4\n```\n");
  CHECK(mentions(table, "<th>Euler</th><th>grows</th><th class=\"words\">verdict</th>",
                 "<td>exploded</td><td>always</td><td class=\"words\">good</td>"));
}

TEST_CASE("what touches a formula stays in its line") {
  const Project project;
  CHECK(project.converted("As $x$, and ($y$) is $z$-like: *$u$*.\n") ==
        "As <span class='unbroken'>\\f$x\\f$,</span> and <span "
        "class='unbroken'>(\\f$y\\f$)</span> is <span "
        "class='unbroken'>\\f$z\\f$-like:</span> *\\f$u\\f$*.\n");
  CHECK(project.converted("| $x$, | ($y$) |\n") == "| \\f$x\\f$, | (\\f$y\\f$) |\n");
}

TEST_CASE("a vector and a formula of a few letters stay in one line") {
  const Project project;
  CHECK(
      project.converted("At (3, −4, 0.5) N, (1, 2), f(x, 3) and 2 + 3 = 5, or so = −1 (a, b).\n") ==
      "At (3,\u00a0−4,\u00a00.5) N, (1,\u00a02), f(x,\u00a03) and 2\u00a0+\u00a03\u00a0=\u00a05, "
      "or "
      "so\u00a0=\u00a0−1 (a,\u00a0b).\n");
  CHECK(
      project.converted("L = m r × (ω × r), t + h, a step h. B b, ½ L·ω, n ≤ 3 | = |\n") ==
      "L\u00a0=\u00a0m\u00a0r\u00a0×\u00a0(ω\u00a0×\u00a0r), t\u00a0+\u00a0h, a step h. B\u00a0b, "
      "½\u00a0L·ω, n\u00a0≤\u00a03 | = |\n");
  CHECK(project.converted("Σ (p − c) (p − c)ᵀ, R_i(α) R_j(β), −∫ x y dm, if v_z < 0\n") ==
        "Σ\u00a0(p\u00a0−\u00a0c)\u00a0(p\u00a0−\u00a0c)ᵀ, R<sub>i</sub>(α)\u00a0R<sub>j</sub>(β), "
        "−∫\u00a0x\u00a0y dm, if v<sub>z</sub>\u00a0&lt;\u00a00\n");
  CHECK(project.converted("(p − c)(p − c)ᵀ, − sin t, sin to\n") ==
        "(p\u00a0−\u00a0c)\u2060(p\u00a0−\u00a0c)ᵀ,\u00a0−\u00a0sin\u00a0t, sin to\n");
  CHECK(project.converted("|t| |L| (1 + a), 14 min, | a | (b) |\n") ==
        "|t|\u2060\u00a0|L|\u2060\u00a0(1\u00a0+\u00a0a), 14\u00a0min, | a | (b) |\n");
  CHECK(project.converted("8 · 0.6 · (1 + 2), (½, −½), 5–48\n") ==
        "8 ·\u00a00.6 ·\u00a0(1\u00a0+\u00a02), (½,\u00a0−½), 5–\u206048\n");
  CHECK(project.converted("|q|², body → world\n") == "|q|\u2060², body\u00a0→\u00a0world\n");
  CHECK(project.converted("With $x$ = 8, ½ kg, $E$ J, or 1.5e-12.\n") ==
        "With <span class='unbroken'>\\f$x\\f$\u00a0=\u00a08,</span> ½\u00a0kg, <span "
        "class='unbroken'>\\f$E\\f$\u00a0J,</span> or 1.5e-\u206012.\n");
}

TEST_CASE("the head of a column breaks between words, and not in a formula") {
  CHECK(with_whole_formulas("‖RᵀR − 1‖ at most") == "‖RᵀR\u00a0−\u00a01‖ at most");
  CHECK(with_whole_formulas("inertia [kg m²]") == "inertia [kg\u00a0m²]");
  CHECK(with_whole_formulas("DP 5(4), x and z") == "DP\u00a05(4), x and z");
  CHECK(with_whole_formulas("y' = −1 (y − cos t)") ==
        "y'\u00a0=\u00a0−1\u00a0(y\u00a0−\u00a0cos\u00a0t)");
  CHECK(with_whole_formulas("y' = −1000 (y − t), to ±… i") ==
        "y'\u00a0=\u00a0−1000\u00a0(y\u00a0−\u00a0t), to\u00a0±…\u00a0i");
  CHECK(with_whole_formulas("a (a⁻¹ b)ᵗ, q p conjugate(q)") ==
        "a\u00a0(a⁻¹\u00a0b)ᵗ, q\u00a0p\u00a0conjugate(q)");
  CHECK(with_whole_formulas("v + ω × (R p_body)") == "v\u00a0+\u00a0ω\u00a0×\u00a0(R\u00a0p_body)");
}

TEST_CASE("a symbol's index is below, and names of the code stay as they are") {
  const Project project;
  CHECK(project.converted("if v_z < 0 or |v_z| <= 1\n") ==
        "if v<sub>z</sub>\u00a0&lt;\u00a00 or |v<sub>z</sub>| <=\u00a01\n");
  CHECK(project.converted("K_nt and n_γ, (R_i), `K_nt`, I_body_inv, a_file.hpp, x_.\n") ==
        "K<sub>nt</sub> and n<sub>γ</sub>, (R<sub>i</sub>), `K_nt`, I_body_inv, a_file.hpp, x_.\n");
  CHECK(project.converted("R [ω]× Rᵀ, [ω]×R\n") == "R [ω]<sub>×</sub> Rᵀ, [ω]<sub>×</sub>R\n");
  CHECK(project.converted("- *n_γ and n_α*: two, *one*, **K_nt** and *2 v_z*.\n") ==
        "- <em>n<sub>γ</sub> and n<sub>α</sub></em>: two, *one*, **K<sub>nt</sub>** and "
        "<em>2 v<sub>z</sub></em>.\n");
}

TEST_CASE("a number stays with its unit") {
  const Project project;
  CHECK(project.converted("By 8 N s. End.\n") == "By 8\u00a0N\u00a0s. End.\n");
  CHECK(project.converted("A share of 5 %, 3 m/s, 2 kg m², order 5, but 5 apples and `7 m`.\n") ==
        "A share of 5\u00a0%, 3\u00a0m/s, 2\u00a0kg\u00a0m², order\u00a05, but 5 apples and `7 "
        "m`.\n");
}

TEST_CASE("straight quotes become round ones: Doxygen would leave what is in them alone") {
  const Project project;
  CHECK(project.converted("| \"now *here*\" | (\"$x$\") | `a \"b\"` | *\"so\"* |\n") ==
        "| “now *here*” | (“\\f$x\\f$”) | `a \"b\"` | *“so”* |\n");
  CHECK(project.converted("## What `--json` gives\n").starts_with("## What \\--json gives {#"));
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
  CHECK(mentions(
      site, "<figcaption>Figure\u00a01.1. How \\(x\\) falls, by <code>f</code>.</figcaption>"));
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
        "<span class='unbroken'>\\f$x\\f$?</span>\n\n```sh\nls\n```\n\\htmlonly[block] </div> "
        "\\endhtmlonly\n> A quotation.\n");
  CHECK_THROWS_WITH(project.converted("Text.\n> **Try it.** What?\n"),
                    doctest::Contains("line above a box is empty"));
  CHECK_THROWS_WITH(project.converted("\n> **Try it.** What?\nText.\n"),
                    doctest::Contains("line below a box is empty"));
  for (const char* list : {"- One.\n", "- One,\n  and more.\n", "12. Twelve.\n"})
    CHECK_THROWS_WITH(project.converted(list + std::string("\n> **Try it.** What?\n")),
                      doctest::Contains("between a list and a box"));
  CHECK_NOTHROW(project.converted("It ends in 3. Text.\n\n> **Try it.** What?\n\n"));
}

TEST_CASE("two boxes below each other are two") {
  const Project project;
  const std::string site =
      project.converted("Text.\n\n> **Try it.** What?\n\n> **For the curious.** Why?\n\nText.\n");
  CHECK(mentions(site,
                 "What?\n\\htmlonly[block] </div><div class=\"curious\"> \\endhtmlonly\n**For"));
}

TEST_CASE("a second page of a chapter has a name of its own, and so have files and folders") {
  CHECK(page_id("/p", "/p/chapters/08_eight/README.md") == "chapters-08_eight");
  CHECK(page_id("/p", "/p/chapters/08_eight/digits.md") == "chapters-08_eight-digits");
  CHECK(page_id("/p", "/p/README.md") == "readme");
  CHECK(page_id("/p", "/p/CHANGELOG.md") == "CHANGELOG");
  CHECK(page_id("/p", "/p/.github/SECURITY.md") == "github-SECURITY");
  CHECK(page_id("/p", "/p/lib/reference/a.hpp") == "lib-reference-a_hpp");
}

TEST_CASE("a figure's place is kept, and the drawing is put there when Doxygen is through") {
  const Project project;
  const std::string site = project.converted("![How $x$ falls.](figures/a.svg)\n");
  CHECK(mentions(site, "<figure>", "<figcaption>How \\(x\\) falls.</figcaption>"));
  CHECK(mentions(project.converted("![If $a<b$ & c.](figures/a.svg)\n"),
                 "<figcaption>If \\(a&lt;b\\) &amp; c.</figcaption>"));
  project.write("html/page.html", "before " + site + " after");
  finish_site(project.path(), project.path() / "html");
  const std::string page = text_of(project.path() / "html/page.html");
  CHECK(mentions(page, "before", "a.svg\"><svg>drawn</svg></div>", "after"));
}

TEST_CASE("a finished page has a heading, its own link marked, and tables in frames") {
  const Project project;
  project.write("html/a.html",
                "<nav id=\"sidebar\"><a href=\"b.html\">B</a><a href=\"a.html\">A</a></nav>"
                "<div class=\"title\">A </div><p>A.</p><table class=\"markdownTable\"></table>");
  finish_site(project.path(), project.path() / "html");
  CHECK(text_of(project.path() / "html/a.html") ==
        "<nav id=\"sidebar\"><a href=\"b.html\">B</a><a aria-current=\"page\" href=\"a.html\">A</a>"
        "</nav><h1 class=\"title\">A </h1><p>A.</p><div class=\"scroll\" tabindex=\"0\"><table "
        "class=\"markdownTable\"></table></div>");
}

TEST_CASE("a type's colour is for whole words") {
  const Project project;
  const std::string coloured = "<span class=\"keywordtype\">int</span>";
  project.write("html/a.html", " " + coloured + " po" + coloured + "s " + coloured + "eger\n");
  finish_site(project.path(), project.path() / "html");
  CHECK(text_of(project.path() / "html/a.html") == " " + coloured + " points integer\n");
}

TEST_CASE("the front page has a name that tells it from the others") {
  const Project project;
  project.write("html/index.html", "<title>tumble – tumble</title>");
  finish_site(project.path(), project.path() / "html");
  CHECK(text_of(project.path() / "html/index.html") ==
        "<title>tumble: rigid-body dynamics by building it</title>");
}

TEST_CASE("the signature of an exercise leads nowhere, other code leads to the library") {
  const Project project;
  const std::string linked =
      "<div class=\"fragment\"><a class=\"code hl_function\" "
      "href=\"l.html\">turn</a>(p);</div><!-- "
      "fragment -->";
  project.write("html/a.html",
                linked + "<div class=\"now-write\"><p>4.3</p>" + linked + "</div>" + linked);
  finish_site(project.path(), project.path() / "html");
  CHECK(
      text_of(project.path() / "html/a.html") ==
      linked +
          "<div class=\"now-write\"><p>4.3</p><div class=\"fragment\">turn(p);</div><!-- fragment "
          "--></div>" +
          linked);
  project.write("html/e.html",
                "<title>Exercises: 4</title>" + linked + "<a class=\"el\">cross()</a>");
  finish_site(project.path(), project.path() / "html");
  CHECK(
      text_of(project.path() / "html/e.html") ==
      "<title>Exercises: 4</title><div class=\"fragment\">turn(p);</div><!-- fragment -->cross()");
}
