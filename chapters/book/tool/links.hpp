#pragma once
/// @file
/// Links and figures of a page, and the anchors of its headings.

#include <cstddef>
#include <string>
#include <vector>

#include "book/tool/page.hpp"

namespace tumble::book {

/// `[text](target)` or `![text](target)`.
struct Link {
  std::size_t begin = 0, end = 0;  ///< in its line
  bool image = false;
  std::string text, target;
};

/// The links of a line that is outside of fences.
std::vector<Link> links_in(const std::string& line);

/// GitHub's name for a heading: "What it costs" → "what-it-costs".
std::string anchor_of(const std::string& heading);

/// The level of a heading line and its text; level 0 for any other line.
struct Heading {
  std::size_t level = 0;
  std::string text;
};
Heading heading_in(const std::string& line);

/// The links that lead nowhere: "file:line: …" each. External addresses are not followed.
std::vector<std::string> dead_links(const Page& page);

}  // namespace tumble::book
