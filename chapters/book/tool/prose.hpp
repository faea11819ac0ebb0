#pragma once
/// @file
/// What of a page is prose: paragraphs without code, tables, formulas and headings.

#include <cstddef>
#include <string>
#include <vector>

#include "book/tool/page.hpp"

namespace tumble::book {

/// A paragraph, an item of a list or a caption, in one line.
struct Paragraph {
  std::size_t line = 0;  ///< its first, from 0
  std::string section;   ///< the heading above; the page's title before the first one
  std::string text;      ///< as it is in the page
  bool excused = false;  ///< `<!-- voice: reason -->` is the line above
};

std::vector<Paragraph> paragraphs_of(const Page& page);

/// What is read aloud: words of links, no code, and "$" in the place of each formula.
std::string spoken(const std::string& text);

std::string lower_case(std::string text);

}  // namespace tumble::book
