#pragma once
/// @file
/// The page of the library leads from each name to its reference.

#include <string>
#include <vector>

#include "book/tool/search_index.hpp"

namespace tumble::book {

/// Makes links of the names in the tables of lib/README.md: `<code>Box</code>` is tumble::Box, and
/// below a cell that begins with `<code>tumble::boxes</code>` it is tumble::boxes::Box.
/// @param names what Doxygen has documented, as names_in() gives it
std::string with_reference_links(const std::string& html, const std::vector<Entry>& names);

}  // namespace tumble::book
