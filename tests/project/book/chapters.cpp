/// @file
/// The form and the voice of a chapter: each case takes one thing from a chapter that has all.
#include <doctest/doctest.h>

#include <string>

#include "book/tool/check.hpp"
#include "book/tool/exercises.hpp"
#include "book/tool/terms.hpp"
#include "book/tool/voice.hpp"
#include "project/harness/temporary_folder.hpp"

using namespace tumble::book;

namespace {

const std::string block =
    "<!-- exercise: 2.1 -->\n"
    "> **Now write 2.1: `twice`.** A number doubled.\n"
    ">\n"
    "> <!-- signature: exercises/02_two/contract.hpp#twice -->\n"
    "> ```cpp\n"
    "> int twice(int x);\n"
    "> ```\n"
    ">\n"
    "> [The contract](../../exercises/02_two/contract.hpp) says exactly what it takes and gives. "
    "Ask the judge:\n"
    ">\n"
    "> ```sh\n"
    "> ./tumble check 2.1\n"
    "> ```\n"
    ">\n"
    "> <details><summary>A hint</summary>\n"
    ">\n"
    "> Add it\n"
    "> to itself.\n"
    ">\n"
    "> </details>\n";

const std::string question = "> **Try it.** What do you see?\n";

const std::string whole =
    "# 2 Two\n\nWe write what you read. A sum is **associative**: brackets make no difference.\n\n"
    "![A drawing](figures/a.svg)\n\n*Figure 2.1. What you see.*\n\n" +
    block + "\n" + question + "\n" + question + "\n" + question +
    "\n## What we have now\n\nYou and us.\n\n## Challenges\n\nYours.\n\n"
    "[← 1 One](../01_one/README.md) · [Terms](../terms/README.md) · "
    "[3 Three →](../03_three/README.md)\n";

/// A book of three chapters, of which the second is checked.
class Chapters : public tumble::test::TemporaryFolder {
 public:
  Chapters() {
    write("README.md", "# Front\n");
    write("chapters/01_one/README.md", "# 1 One\n\nA page.\n");
    write("chapters/03_three/README.md", "# 3 Three\n\nA page.\n");
    write("chapters/02_two/figures/a.svg", "<svg/>\n");
    write("chapters/book/pages_to_rewrite.txt",
          "chapters/01_one/README.md\nchapters/03_three/README.md\n");
    write("chapters/book/idioms.txt",
          "# a list\none has to = you have to\nlike $ = proportional to\n");
    write("exercises/01_one/contract.hpp", "");
    write("exercises/03_three/contract.hpp", "");
    write("exercises/02_two/contract.hpp",
          "// == 2.1 twice: a number doubled\nint twice(int x);\n");
    write("exercises/02_two/hints.md", "## 2.1 twice\n\n1. Add it\n   to itself.\n2. x + x\n");
  }

  fs::path page() const { return path() / "chapters/02_two/README.md"; }

  /// What is wrong with the book if this is its second chapter, and its terms are listed.
  std::string mistakes(const std::string& text) const {
    write("chapters/02_two/README.md", text);
    fs::create_directories(place_of_terms(path()).parent_path());
    write_page(fresh_terms(path()));
    return mistakes_now();
  }

  std::string mistakes_now() const {
    std::string all;
    for (const std::string& mistake : mistakes_in(Places{path(), path()})) all += mistake + "\n";
    return all;
  }
};

std::string with(const std::string& old_text, const std::string& new_text) {
  std::string text = whole;
  return text.replace(text.find(old_text), old_text.size(), new_text);
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string joined(const Page& page) {
  std::string text;
  for (const std::string& line : page.lines) text += line + "\n";
  return text;
}

}  // namespace

TEST_CASE("a chapter that has everything has no mistakes") {
  const Chapters book;
  CHECK(book.mistakes(whole) == "");
}

TEST_CASE("an exercise is what contract and hints say, and writing makes it so") {
  const Chapters book;
  CHECK(says(book.mistakes(with("int twice(int x);", "int twice(long x);")),
             ":9: exercise 2.1 is not what contract and hints say"));
  CHECK(says(book.mistakes(with("> to itself.", "> to something.")), "exercise 2.1 is not"));
  CHECK(says(book.mistakes(with("exercise: 2.1", "exercise: 2.7")), ":9: "));
  CHECK(says(book.mistakes(with(block, "")), "exercise 2.1 has 0 blocks"));
  book.write("chapters/02_two/README.md", with(block, "<!-- exercise: 2.1 -->\n"));
  CHECK(joined(with_fresh_exercises(book.path(), read_page(book.page()))) == whole);
}

TEST_CASE("output in a box is filled in, and compared") {
  const Chapters book;
  book.write("02_two", "#!/bin/sh\nprintf 'a  1\\n\\nb  2\\n'\n");
  fs::permissions(book.path() / "02_two", fs::perms::owner_all);
  const std::string fresh =
      "> <!-- output: 02_two#table -->\n> ```text\n> a  1\n>\n> b  2\n> ```\n";
  CHECK(book.mistakes(with(question, question + ">\n" + fresh)) == "");
  const std::string stale = "> <!-- output: 02_two#table -->\n> ```text\n> a  2\n> ```\n";
  CHECK(says(book.mistakes(with(question, question + ">\n" + stale)), "has changed"));
  const Page page = refreshed(Places{book.path(), book.path()}, read_page(book.page()));
  CHECK(says(joined(page), fresh));
}

TEST_CASE("a figure has a caption with its number, in the order of the page") {
  const Chapters book;
  CHECK(says(book.mistakes(with("*Figure 2.1. What you see.*\n\n", "")), ":5: two lines below"));
  CHECK(says(book.mistakes(with("Figure 2.1.", "Figure 2.2.")), "*Figure 2.1. …*"));
}

TEST_CASE("the figures of a second page count on from those of the first") {
  const Chapters book;
  const auto second = [](const std::string& number) -> std::string {
    return "# More\n\nWe go on with you.\n\n![A drawing](figures/a.svg)\n\n*Figure " + number +
           ". Again.*\n\n[← 2 Two](README.md) · [Terms](../terms/README.md) · "
           "[3 Three →](../03_three/README.md)\n";
  };
  const std::string first = with("[3 Three →](../03_three/README.md)", "[More →](more.md)");
  book.write("chapters/02_two/more.md", second("2.2"));
  CHECK(book.mistakes(first) == "");
  book.write("chapters/02_two/more.md", second("2.1"));
  CHECK(says(book.mistakes(first), "*Figure 2.2. …*"));
}

TEST_CASE("a chapter has questions, a summary, challenges and links to its neighbours") {
  const Chapters book;
  CHECK(says(book.mistakes(with(question + "\n", "")), "at least three questions"));
  CHECK(says(book.mistakes(with("## What we have now", "## Summary")), "## What we have now"));
  CHECK(says(book.mistakes(with("## Challenges", "## More")), "## Challenges"));
  CHECK(says(book.mistakes(with("[← 1 One]", "[1 One]")), "ends with the line [← 1 One]"));
  fs::remove_all(book.path() / "chapters/03_three");  // a hand-out without it
  CHECK(book.mistakes(with(" · [3 Three →](../03_three/README.md)", "")) == "");
}

TEST_CASE("a page speaks to its reader, without the idioms of the list") {
  const Chapters book;
  const std::string words =
      "Water runs down the hill and into the sea and nothing stops it there. ";
  std::string dry;
  for (int i = 0; i < 80; ++i) dry += words;
  CHECK(says(book.mistakes(with("We write", dry + "We write")), "in a thousand words"));
  CHECK(says(book.mistakes(with("You and us.", "One has\nto see us.")),
             "“one has to”: write you have to"));
  CHECK(book.mistakes(with("You and us.", "Someone has to see us, in `one has to`.")) == "");
  CHECK(book.mistakes(
            with("You and us.", "<!-- voice: quoted -->\nOne has to, as they say to you.")) == "");
  CHECK(says(book.mistakes(with("You and us.", "You see: it falls like $h^2$.")), "“like $”"));
  CHECK(book.mistakes(with("You and us.", "It stops like you do.")) == "");
}

TEST_CASE("a page that a command writes has the voice of where its sentences are") {
  const tumble::test::TemporaryFolder folder;
  folder.write("page.md",
               "# All\n\n<!-- This page is written by `./tumble x`. -->\n\nOne has to.\n");
  const std::vector<Idiom> idioms{{"one has to", "you must"}};
  CHECK(mistakes_of_voice(read_page(folder.path() / "page.md"), idioms).empty());
  folder.write("page.md", "# All\n\nOne has to.\n");
  CHECK(mistakes_of_voice(read_page(folder.path() / "page.md"), idioms).size() == 2);
}

TEST_CASE("a page on the list of those to rewrite may be anything but ready") {
  const Chapters book;
  book.write("chapters/book/pages_to_rewrite.txt",
             "chapters/01_one/README.md\nchapters/02_two/README.md\nchapters/03_three/README.md\n");
  CHECK(book.mistakes("# 2 Two\n\nOne has to read a **page** twice.\n") == "");
  CHECK(says(book.mistakes(whole), "02_two/README.md:1: strike this page off"));
}

TEST_CASE("terms are in bold once, and listed with the sentence that introduces them") {
  const Chapters book;
  book.mistakes(whole);
  const std::string list = joined(fresh_terms(book.path()));
  CHECK(says(list,
             "- [associative](../02_two/README.md#2-two): A sum is associative: brackets "
             "make no difference.\n"));
  CHECK_FALSE(says(list, "Try it"));
  book.write("chapters/02_two/README.md",
             with("You and us.", "You feel wind. We call it **drag**."));
  CHECK(says(joined(fresh_terms(book.path())), "): You feel wind. We call it drag.\n"));
  // A run-in heading is not part of the first sentence.
  book.write("chapters/02_two/README.md",
             with("You and us.", "**In air.** You feel wind. We call it **drag**."));
  CHECK(says(joined(fresh_terms(book.path())), "): You feel wind. We call it drag.\n"));
  const auto listed = [&](const std::string& under, const std::string& mark = ":") {
    book.write("chapters/02_two/README.md",
               with("You and us.", "You step with **Euler's method**" + mark + "\n\n" + under));
    return joined(fresh_terms(book.path()));
  };
  CHECK(says(listed("```math\ny_1 = y\n+ h f\n```\n"), "with Euler's method: $`y_1 = y + h f`$\n"));
  CHECK(says(listed("```math\n\\begin{aligned}\na &= b\n\\end{aligned}\n```\n"),
             "with Euler's method.\n"));
  CHECK(says(listed("```text\n1 2\n```\n"), "with Euler's method.\n"));
  // A sentence that goes on in the formula under it.
  CHECK(says(listed("```math\ny_1 = y\n```\n", ""), "with Euler's method $`y_1 = y`$\n"));
  CHECK(says(listed("```math\n\\begin{aligned}\na &= b\n\\end{aligned}\n```\n", ""),
             "with Euler's method …\n"));
  CHECK(says(book.mistakes(with("You and us.", "You know **associative** sums.")),
             "is in bold already at"));
  const std::string page = "chapters/02_two/README.md";
  book.write(page, with("You and us.", "You know **the $x$ axis**."));
  CHECK(says(book.mistakes_now(), "README.md:38: a formula in bold"));
  book.write(page, with("You and us.", "You know **this."));
  CHECK(says(book.mistakes_now(), "has no partner"));
  book.mistakes(whole);
  book.write("chapters/terms/README.md", "# Terms\n");
  CHECK(says(book.mistakes_now(), "terms/README.md:1: is not what the pages say"));
  // One kind of mistake doesn't hide another.
  book.write(page, with("You and us.", "You see [nothing](nowhere.md)."));
  const std::string both = book.mistakes_now();
  CHECK(says(both, "nowhere.md"));
  CHECK(says(both, "terms/README.md:1: is not what the pages say"));
}

TEST_CASE("a list of idioms that cannot be read is refused with its line") {
  const Chapters book;
  book.write("chapters/book/idioms.txt", "# a list\none has to\n");
  CHECK(says(book.mistakes(whole), "idioms.txt:2: a line is: idiom = instead"));
}
