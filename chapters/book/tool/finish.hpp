#pragma once
/// @file
/// What the tool does to the pages that Doxygen has made.

#include "book/tool/page.hpp"

namespace tumble::book {

/// Puts the drawings where for_doxygen() has left their places, marks in the list of pages the one
/// that is read, and makes headings of Doxygen's titles.
/// @param folder with the pages
/// @throws PageError if a drawing is not there
void finish_site(const fs::path& root, const fs::path& folder);

}  // namespace tumble::book
