#pragma once
/// @file
/// What the site adds at the top of a page: the links to its neighbours, and its contents.

#include <string>

#include "book/tool/page.hpp"

namespace tumble::book {

/// The name of a heading in the site: that of the page, with GitHub's name behind it.
std::string heading_id(const fs::path& root, const Page& page, const std::string& heading);

/// The links of the page's last line, if that is the one to its neighbours: HTML for its top or its
/// end. Empty for any other page.
std::string neighbours_html(const fs::path& root, const Page& page);

/// The sections of the page, as a list of links; empty if there are fewer than three.
std::string contents_html(const fs::path& root, const Page& page);

}  // namespace tumble::book
