#pragma once
/// @file
/// Which files of the project the site holds: the book, and all that its pages lead to.

#include <string>
#include <vector>

#include "book/tool/page.hpp"

namespace tumble::book {

struct SiteFiles {
  std::vector<fs::path> pages;      ///< Markdown, the front page first, each once
  std::vector<fs::path> exercises;  ///< folders exercises/NN_name
  std::vector<fs::path> shown;      ///< other files and folders that pages lead to
};

/// Follows the links of the book's pages, and of the pages that they lead to.
/// @throws PageError if a page cannot be read
SiteFiles site_files(const fs::path& root);

}  // namespace tumble::book
