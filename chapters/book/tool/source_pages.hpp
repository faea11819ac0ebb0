#pragma once
/// @file
/// Pages that show files: solutions, specifications and what else a page of the book leads to.

#include "book/tool/page.hpp"

namespace tumble::book {

/// The page of a file, or of all files in a folder, folded.
/// @return a page with the path of the file, or README.md in the folder, which it is not
/// @throws PageError if one cannot be read
Page source_page(const fs::path& root, const fs::path& what);

}  // namespace tumble::book
