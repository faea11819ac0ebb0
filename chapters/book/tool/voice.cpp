#include "book/tool/voice.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <sstream>

#include "book/tool/prose.hpp"

namespace tumble::book {

namespace {

constexpr double least = 12;  // of you and we in a thousand words; a good teacher has 30

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Words of letters: "we'll" is "we" and "ll".
std::vector<std::string> words_in(const std::string& text) {
  std::vector<std::string> words;
  bool inside = false;
  for (const char c : lower_case(text)) {
    const bool letter = is_letter(c) || static_cast<unsigned char>(c) >= 0x80;
    if (letter && !inside) words.emplace_back();
    if (letter) words.back() += c;
    inside = letter;
  }
  return words;
}

/// Where the words are in the text, not as parts of longer words; npos if nowhere.
std::size_t find_words(const std::string& text, const std::string& words) {
  for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) {
    const std::size_t end = at + words.size();
    const bool begins = at == 0 || !is_letter(text[at - 1]) || !is_letter(words.front());
    const bool ends = end >= text.size() || !is_letter(text[end]) || !is_letter(words.back());
    if (begins && ends) return at;
  }
  return std::string::npos;
}

/// "<!-- This page is written by `./tumble …`": from sentences that are elsewhere.
bool is_collected(const Page& page) {
  return std::any_of(page.lines.begin(), page.lines.end(), [](const std::string& line) {
    return line.starts_with("<!-- This page is written by `./tumble ");
  });
}

}  // namespace

std::vector<Idiom> read_idioms(const fs::path& file) {
  const Page list = read_page(file);
  std::vector<Idiom> idioms;
  for (std::size_t i = 0; i < list.lines.size(); ++i) {
    const std::string& line = list.lines[i];
    if (line.empty() || line.starts_with("#")) continue;
    const auto equals = line.find(" = ");
    if (equals == std::string::npos || equals == 0) fail(list, i, "a line is: idiom = instead");
    idioms.push_back({lower_case(line.substr(0, equals)), line.substr(equals + 3)});
  }
  return idioms;
}

double you_and_we(const Page& page) {
  static const std::set<std::string> forms{"you", "your", "yours", "yourself", "we",
                                           "us",  "our",  "ours",  "ourselves"};
  std::size_t words = 0, addressed = 0;
  for (const Paragraph& paragraph : paragraphs_of(page)) {
    if (paragraph.section == "Sources") continue;
    for (const std::string& word : words_in(spoken(paragraph.text))) {
      ++words;
      if (forms.contains(word)) ++addressed;
    }
  }
  return words == 0 ? 1000 : 1000.0 * static_cast<double>(addressed) / static_cast<double>(words);
}

std::vector<std::string> mistakes_of_voice(const Page& page, const std::vector<Idiom>& idioms) {
  std::vector<std::string> mistakes;
  if (is_collected(page)) return mistakes;
  for (const Paragraph& paragraph : paragraphs_of(page)) {
    if (paragraph.excused || paragraph.section == "Sources") continue;
    const std::string text = lower_case(spoken(paragraph.text));
    for (const Idiom& idiom : idioms)
      if (find_words(text, idiom.words) != std::string::npos)
        mistakes.push_back(at(page, paragraph.line) + "“" + idiom.words + "”: write " +
                           idiom.instead + ", or excuse it above: <!-- voice: reason -->");
  }
  if (const double rate = you_and_we(page); rate < least) {
    std::ostringstream text;
    text << at(page, 0) << "“you” and “we” stand " << std::round(10 * rate) / 10
         << " times in a thousand words; a page that speaks to its reader has " << least
         << " or more";
    mistakes.push_back(text.str());
  }
  return mistakes;
}

}  // namespace tumble::book
