#pragma once
/// @file
/// Where the site has what a page links to. Every file that a page names is there: pages as pages,
/// contract and hints of a chapter as one page, any other file or folder as a page that shows it.

#include <string>

#include "book/tool/page.hpp"

namespace tumble::book {

/// The name by which the site knows a page: "chapters-04_quaternions", "chapters-08_mirtich-digits"
/// for a second page there; "readme" for the front page; "lib-reference-times_hpp" for a file.
std::string page_id(const fs::path& root, const fs::path& file);

/// The folder exercises/NN_name whose contract or hints this is; empty for any other file.
fs::path exercise_folder(const fs::path& root, const fs::path& file);

/// The site's file for a page, file or folder: "index.html", "exercises-04_quaternions.html".
std::string address_of(const fs::path& root, const fs::path& file);

/// Whether Doxygen has a page for it: a header of the library.
bool is_public_header(const fs::path& root, const fs::path& file);

/// The place of an exercise in the page of its chapter's exercises.
/// @param folder exercises/NN_name @param number "4.1"
std::string exercise_anchor(const fs::path& root, const fs::path& folder,
                            const std::string& number);

}  // namespace tumble::book
