#pragma once
/// @file
/// Figures of a page and their captions: a paragraph in italics under the picture, which GitHub
/// shows as it is, and of which the site makes the figure's caption.

#include <cstddef>
#include <string>
#include <vector>

#include "book/tool/page.hpp"

namespace tumble::book {

struct Figure {
  std::size_t line = 0;            ///< of the picture, from 0
  std::size_t first = 0, end = 0;  ///< lines of the caption; none where they are equal
  std::string picture;             ///< the file, as the page names it
  std::string alternative;         ///< what is read out where the picture cannot be seen
  std::string caption;             ///< without its asterisks, in one line
};

std::vector<Figure> figures_of(const Page& page);

}  // namespace tumble::book
