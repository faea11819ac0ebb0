#pragma once
/// @file
/// A stream as blocks of whole lines: a large file never lies in memory as a whole, which would
/// cost more than reading its numbers.

#include <algorithm>
#include <cstddef>
#include <istream>
#include <string>
#include <string_view>

namespace tumble::detail {

/// Whether a line ends with the first `length` letters. Of \r\n, both belong to it; a \r at the
/// very end of the text may be the first of them. A line that ends with a backslash goes on.
bool ends_line(std::string_view text, std::size_t length);

/// The length of the whole lines at the beginning.
std::size_t whole_lines(std::string_view text);

/// Calls `visit(block)` for all of the stream, block by block; a block ends with a line. Of an
/// empty stream there is one empty block.
/// @param size of a block [bytes], at least; more where a line is longer
/// @return whether all was read without an error
template <class Visit>
bool for_each_block_of_lines(std::istream& in, std::size_t size, Visit&& visit) {
  std::string buffer(2 * size, '\0');
  std::size_t filled = 0;
  while (in) {
    if (buffer.size() - filled < size) buffer.resize(2 * buffer.size());
    in.read(buffer.data() + filled, static_cast<std::streamsize>(buffer.size() - filled));
    filled += static_cast<std::size_t>(in.gcount());
    const std::string_view text(buffer.data(), filled);
    const std::size_t length = in ? whole_lines(text) : filled;
    if (length > 0 || !in) visit(text.substr(0, length));
    std::copy(text.begin() + static_cast<std::ptrdiff_t>(length), text.end(), buffer.begin());
    filled -= length;
  }
  return !in.bad();
}

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/line_blocks.inl"
#endif
