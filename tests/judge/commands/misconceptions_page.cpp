#include "judge/commands/misconceptions_page.hpp"

#include <fstream>
#include <ostream>
#include <string>

#include "judge/spec/load_spec.hpp"
#include "judge/spec/misconception.hpp"
#include "support/heading_anchor.hpp"

namespace tumble::judge {

namespace {

constexpr const char* beginning =
    R"(# What students get wrong

The judge recognises a mistake by its numbers: it has a wrong function for each, and looks which of them gives your student's answers. Here are all of them, with
what your students read in the verdict, and the section of the book that explains it. Before a homework you see what you may want to say in class; after it,
`./tumble report` counts how often each was met.

<!-- This page is written by `./tumble matrix all --page`, from the specs in `tests/`. -->
)";

/// Text as Markdown: code between backticks stays code, everything else is plain.
std::string escaped(const std::string& text) {
  std::string result;
  bool in_code = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '`') in_code = !in_code;
    const bool scope = text.compare(i, 2, "::") == 0;  // a link to a name, to Doxygen
    const bool special = scope || std::string("*<$\\[").find(text[i]) != std::string::npos;
    if (special && !in_code) result += '\\';
    result += text[i];
  }
  return result;
}

/// Doxygen begins no italics with code.
std::string without_code(std::string text) {
  std::erase(text, '`');
  return text;
}

/// "1 Particles"; the folder's name if the page is not there.
std::string title_of(const Course& course, const Unit& unit) {
  std::ifstream page(course.page(unit));
  std::string line;
  std::getline(page, line);
  return line.starts_with("# ") ? line.substr(2) : unit.chapter;
}

void print_unit(std::ostream& out, const Unit& unit) {
  out << "\n### " << unit.number << " `" << unit.name << "`\n\n";
  for (const Misconception& misconception : misconceptions_of(unit.id()))
    out << "- *" << escaped(without_code(misconception.name))
        << "*: " << escaped(misconception.sentence) << " See [" << misconception.section << "](../"
        << unit.chapter << "/README.md#" << support::heading_anchor(misconception.section)
        << (misconception.section.ends_with('?') ? ")\n" : ").\n");
}

}  // namespace

void print_misconceptions(std::ostream& out, const Course& course, const std::vector<Unit>& units) {
  out << beginning;
  std::string chapter;
  for (const Unit& unit : units) {
    load_spec(unit);
    if (unit.chapter != chapter) out << "\n## " << title_of(course, unit) << "\n";
    chapter = unit.chapter;
    print_unit(out, unit);
  }
}

}  // namespace tumble::judge
