#pragma once
/// @file
/// The field's terms: each is once in bold, where it is introduced, and the page of terms leads
/// there.

#include <cstddef>
#include <string>
#include <vector>

#include "book/tool/page.hpp"

namespace tumble::book {

struct Term {
  std::string name;
  std::string sentence;  ///< the one that introduces it, and the one before a short one
  fs::path page;
  std::string section;  ///< the heading above
  std::size_t line = 0;
};

/// What is in bold on a page. Bold that ends a sentence (**Try it.**) or with a colon begins a
/// paragraph; it is no term.
/// @throws PageError if a formula is in bold, which the site cannot show
std::vector<Term> terms_of(const Page& page);

/// Terms that are in bold twice: "file:line: …" each.
std::vector<std::string> repeated(const std::vector<Term>& terms);

/// The page that lists all terms, in alphabetical order, each with its sentence and a link.
Page page_of_terms(const fs::path& root, std::vector<Term> terms);

/// Where that page is.
fs::path place_of_terms(const fs::path& root);

}  // namespace tumble::book
