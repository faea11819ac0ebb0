#pragma once
/// @file
/// Quotations that are boxes of the book: "Now write", "Try it", and what is for the curious only.

#include <cstddef>
#include <string>
#include <vector>

#include "book/tool/page.hpp"

namespace tumble::book {

struct Box {
  std::size_t first = 0, end = 0;  ///< lines, from 0
  std::string name;                ///< of the style: "now-write", "try-it", "curious"
};

/// @throws PageError if the line before or behind a box is neither empty nor a comment: the site
///         needs them
std::vector<Box> boxes_of(const Page& page);

}  // namespace tumble::book
