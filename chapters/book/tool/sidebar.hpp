#pragma once
/// @file
/// The list of all pages beside each of them.

#include <string>

#include "book/tool/site_files.hpp"

namespace tumble::book {

/// The chapters with their exercises, the rest of the book, the topics of the library, and pages
/// about the project.
std::string sidebar_html(const fs::path& root, const SiteFiles& files);

/// Folders of the library with what they hold, by the table of lib/README.md: for Doxygen.
std::string folder_briefs(const fs::path& root);

}  // namespace tumble::book
