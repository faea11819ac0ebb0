#pragma once
/// @file
/// The form of a chapter: what every page of it has, so that a reader finds it in each.

#include <string>
#include <vector>

#include "book/tool/page.hpp"

namespace tumble::book {

/// Is it a page of a chapter (chapters/09_rigid_body/README.md), not of the tour or the guide?
bool is_chapter(const fs::path& file);

/// The line that a chapter's page ends with: links to the page before and to the one behind, and to
/// the terms. Pages whose neighbour is in another hand-out have less.
/// @param pages of the book, in order
std::string neighbours(const Page& page, const std::vector<fs::path>& pages);

/// What a chapter's page lacks: "file:line: …" each. A chapter's first page has a block for each
/// exercise, three questions to try, two challenges and what we have now; every page has captions,
/// numbered, and links to its neighbours.
/// @param pages of the book, in order
std::vector<std::string> mistakes_of_form(const fs::path& root, const Page& page,
                                          const std::vector<fs::path>& pages);

}  // namespace tumble::book
