#pragma once
/// @file
/// What the tool writes before Doxygen runs.

#include "book/tool/page.hpp"

namespace tumble::book {

/// Writes into `site`: header.html with the list of pages, pages/ with those that are made of
/// contracts and of sources, and inputs.doxy, which names all pages in order.
/// @param theme folder with header.html and footer.html of the book
/// @throws PageError if something cannot be read or written
void prepare_site(const fs::path& root, const fs::path& theme, const fs::path& site);

}  // namespace tumble::book
