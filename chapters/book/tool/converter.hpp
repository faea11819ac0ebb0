#pragma once
/// @file
/// A page as Doxygen wants it, line by line: its warnings keep the line numbers of the page.

#include <string>

#include "book/tool/page.hpp"

namespace tumble::book {

/// The page with Doxygen's formulas, headings with names, links to where the site has their
/// targets, tables of numbers as tables, its contents at the top, and places for its figures.
std::string for_doxygen(const fs::path& root, const Page& page);

}  // namespace tumble::book
