#pragma once
/// @file
/// Editors in a site: what was made for the exercises in a page is put beside the pages.

#include "book/tool/page.hpp"

namespace tumble::book {

/// Copies the exercises to site/exercises and their service worker to the site itself, gives each
/// box "Now write 4.1" a name and the pages that have one their script. Doing it again changes what
/// is new and nothing else.
/// @param site   the folder with index.html
/// @param folder what the site is to serve as exercises/
/// @throws std::invalid_argument if one of the two is not complete: what is missing
void add_editors(const fs::path& site, const fs::path& folder);

}  // namespace tumble::book
