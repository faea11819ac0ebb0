#pragma once
/// @file
/// A page as Doxygen wants it, line by line: its warnings keep the line numbers of the page.

#include <string>

#include "book/tool/page.hpp"

namespace tumble::book {

/// The name by which the site knows a page: "chapters-04_quaternions", "chapters-08_mirtich-digits"
/// for a second page there; "readme" for the front page.
std::string page_id(const fs::path& root, const fs::path& file);

/// The page with Doxygen's formulas, headings with names, links between pages, and figures inside.
std::string for_doxygen(const fs::path& root, const Page& page);

/// Puts the drawings into the pages that Doxygen has made, where for_doxygen has left their places.
/// @throws PageError if a drawing is not there
void fill_in_figures(const fs::path& root, const fs::path& folder);

}  // namespace tumble::book
