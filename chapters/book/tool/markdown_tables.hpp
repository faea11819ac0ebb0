#pragma once
/// @file
/// Tables in Markdown.

#include <string>
#include <vector>

#include "book/tool/page.hpp"

namespace tumble::book {

/// Rows that have not as many cells as their heading, "file:line: …" each: a | in a text has to be
/// written as \|, in code too.
std::vector<std::string> broken_rows(const Page& page);

}  // namespace tumble::book
