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
  std::string exercise;            ///< "4.1" of "Now write 4.1"
};

/// Where links to an exercise lead on its chapter's page: "now-write-4.1".
std::string box_id(const std::string& exercise);

/// @throws PageError if the line before or behind a box is neither empty nor a comment, or if a box
///         follows a list: the site needs what is between
std::vector<Box> boxes_of(const Page& page);

}  // namespace tumble::book
