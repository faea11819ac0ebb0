#pragma once
/// @file
/// The fenced blocks of a page, and what the comments above them say of where they are from.

#include <cstddef>
#include <string>
#include <vector>

#include "book/tool/page.hpp"

namespace tumble::book {

/// A fenced block, and the comment in the line above that says what it shows:
/// `<!-- snippet: lib/include/tumble/rotation/skew.hpp#skew -->`, the same with `signature`, or
/// `<!-- output: 03_rotation_matrices#drift -->`, the same with `measured` where numbers are times.
struct Fence {
  std::size_t opening = 0, closing = 0;  ///< line numbers of the two fences, from 0
  std::string language;                  ///< "cpp", "text", "math", …
  std::string source;                    ///< "snippet", "signature", "output", "measured"; or empty
  std::string path, region;              ///< before and after the #
  bool quoted = false;                   ///< every line of it begins with "> "
};

/// All fences in order.
/// @throws PageError if one is not closed, or a snippet's comment has no fence below it
std::vector<Fence> fences_of(const Page& page);

/// The lines between the two fences.
std::string content_of(const Page& page, const Fence& fence);

/// Where a kind of line is: outside of fences, formulas and links mean something.
bool is_inside(const std::vector<Fence>& fences, std::size_t line);

}  // namespace tumble::book
