#pragma once
/// @file
/// The book in one page, to be printed.

#include <string>

#include "book/tool/site_files.hpp"

namespace tumble::book {

/// What is printed of a finished page: its text, unfolded, without the links that steer a screen. A
/// link to another page that is printed leads there, any other one is plain text.
/// @param page   the HTML of the page
/// @param id     its name
/// @param others names of all pages that are printed
std::string printed_article(const std::string& page, const std::string& id,
                            const std::vector<std::string>& others);

/// Writes print.html into `folder`, which has the finished site: a title, the contents, the
/// chapters and the terms.
void write_printed_book(const fs::path& root, const SiteFiles& files, const fs::path& folder);

}  // namespace tumble::book
