#include "book/tool/terms.hpp"

#include <algorithm>
#include <map>

#include "book/tool/links.hpp"
#include "book/tool/prose.hpp"

namespace tumble::book {

namespace {

/// Whether a sentence begins here: at the start, or behind ". ", "? ", "! " or ".) ".
bool begins_sentence(const std::string& text, std::size_t i) {
  if (i < 3) return i == 0;
  const char last = text[text[i - 2] == ')' ? i - 3 : i - 2];
  return text[i - 1] == ' ' && std::string(".?!").find(last) != std::string::npos;
}

std::size_t begin_of_sentence(const std::string& text, std::size_t place) {
  while (!begins_sentence(text, place)) --place;
  return place;
}

bool is_run_in_heading(const std::string& bold) {
  return std::string(".:?!").find(bold.back()) != std::string::npos;
}

/// Where the text begins that a run-in heading may be before, "**Drag.** Air …".
std::size_t behind_run_in_heading(const std::string& text) {
  const std::size_t end = text.starts_with("**") ? text.find("**", 2) : std::string::npos;
  if (end == std::string::npos || end == 2) return 0;
  return is_run_in_heading(text.substr(2, end - 2)) ? text.find_first_not_of(' ', end + 2) : 0;
}

/// The sentence around a term, with the words of its links and without bold. A short one that ends
/// with the term, "We call this force drag.", leans on the one before it.
/// @param place of its first asterisk
std::string sentence_around(const std::string& text, std::size_t place) {
  constexpr std::size_t short_one = 72, short_rest = 24;  // bytes
  std::size_t begin = begin_of_sentence(text, place), end = place + 1;
  while (end < text.size() && !begins_sentence(text, end)) ++end;
  const std::size_t rest = end - text.find("**", place + 2);
  if (begin > 0 && end - begin < short_one && rest < short_rest)
    begin = begin_of_sentence(text, begin - 1);
  if (begin == 0 && text.starts_with("- ")) begin = 2;
  if (begin == 0) begin = behind_run_in_heading(text);
  std::string sentence = text.substr(begin, end - begin), plain;
  std::size_t at = 0;
  for (const Link& link : links_in(sentence)) {
    plain += sentence.substr(at, link.begin - at) + link.text;
    at = link.end;
  }
  plain += sentence.substr(at);
  for (auto bold = plain.find("**"); bold != std::string::npos; bold = plain.find("**"))
    plain.erase(bold, 2);
  while (plain.ends_with(" ")) plain.pop_back();
  return plain;
}

/// The displayed formula under a paragraph, as one in a line of text; empty if there is none, or
/// if it has several lines, which would not break on a phone.
/// @param line the paragraph's first
std::string formula_under(const std::vector<std::string>& lines, std::size_t line) {
  while (line < lines.size() && !lines[line].empty()) ++line;
  if (line + 1 >= lines.size() || lines[line + 1] != "```math") return "";
  std::string formula;
  for (line += 2; line < lines.size() && lines[line] != "```"; ++line)
    formula += (formula.empty() ? "" : " ") + lines[line];
  return formula.find("\\begin") == std::string::npos ? "$`" + formula + "`$" : "";
}

/// A sentence that goes on under its paragraph takes its formula along. What else is there, a
/// figure or a listing, stays where it is.
std::string completed(std::string sentence, const std::string& formula) {
  if (std::string(".!?)").find(sentence.back()) != std::string::npos) return sentence;
  if (!formula.empty()) return sentence + " " + formula;
  if (!sentence.ends_with(":")) return sentence + " …";
  sentence.back() = '.';
  return sentence;
}

}  // namespace

std::vector<Term> terms_of(const Page& page) {
  std::vector<Term> terms;
  for (const Paragraph& paragraph : paragraphs_of(page)) {
    const std::string& text = paragraph.text;
    const std::string visible = without_code_spans(text);
    for (auto begin = visible.find("**"); begin != std::string::npos;) {
      const auto end = visible.find("**", begin + 2);
      if (end == std::string::npos || end == begin + 2)
        fail(page, paragraph.line, "this ** has no partner in its paragraph");
      const std::string bold = text.substr(begin + 2, end - begin - 2);
      if (bold.find('$') != std::string::npos)
        fail(page, paragraph.line, "a formula in bold: the site shows the asterisks");
      if (!is_run_in_heading(bold)) {
        const std::string formula = formula_under(page.lines, paragraph.line);
        terms.push_back({bold, completed(sentence_around(text, begin), formula), page.file,
                         paragraph.section, paragraph.line});
      }
      begin = visible.find("**", end + 2);
    }
  }
  return terms;
}

std::vector<std::string> repeated(const std::vector<Term>& terms) {
  std::map<std::string, const Term*> first;
  std::vector<std::string> mistakes;
  for (const Term& term : terms) {
    const auto [it, fresh] = first.try_emplace(lower_case(term.name), &term);
    if (!fresh)
      mistakes.push_back(term.page.string() + ":" + std::to_string(term.line + 1) + ": “" +
                         term.name + "” is in bold already at " + it->second->page.string() + ":" +
                         std::to_string(it->second->line + 1) +
                         "; a term is in bold once, where it is introduced");
  }
  return mistakes;
}

fs::path place_of_terms(const fs::path& root) { return root / "chapters/terms/README.md"; }

Page page_of_terms(const fs::path& root, std::vector<Term> terms) {
  std::stable_sort(terms.begin(), terms.end(), [](const Term& a, const Term& b) {
    return lower_case(a.name) < lower_case(b.name);
  });
  const fs::path place = place_of_terms(root);
  const std::string greeting =
      "You met a word and want it again? Here are the terms of the book, each with the "
      "sentence that introduces it, and a link to its place.";
  const std::string origin =
      "<!-- This page is written by `./tumble book --write`, from what is in bold in "
      "the chapters. -->";
  Page page{place, {"# Terms", "", greeting, "", origin, ""}};
  for (const Term& term : terms) {
    const std::string link =
        term.page.lexically_relative(place.parent_path()).string() + "#" + anchor_of(term.section);
    page.lines.push_back("- [" + term.name + "](" + link + "): " + term.sentence);
  }
  return page;
}

}  // namespace tumble::book
