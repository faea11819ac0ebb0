#pragma once
/// @file
/// What the site's search looks through: headings, terms and text of its pages, and names of the
/// library.

#include <string>
#include <vector>

#include "book/tool/page.hpp"

namespace tumble::book {

/// A section of a page, or a name of the library.
struct Entry {
  std::string address, page, section;
  std::string terms, text;  ///< what it introduces, and what it says, without mark-up
};

/// The sections of a page, in order.
std::vector<Entry> entries_of(const fs::path& root, const Page& page);

/// The names in Doxygen's file of tags, but for what is in a namespace detail.
std::vector<Entry> names_in(const std::string& tags);

/// A classic script that sets `tumbleIndex`, as the site's search.js reads it.
std::string script_of(const std::vector<Entry>& entries);

/// search_index.js for the site: its pages and, if Doxygen has written `tags`, the library's names.
void write_search_index(const fs::path& root, const fs::path& tags, const fs::path& file);

}  // namespace tumble::book
