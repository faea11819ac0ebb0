#pragma once
/// @file
/// The column of a chapter's table of exercises that says how many ways to go wrong the judge knows
/// by name. They are counted in the page that lists them, which the judge itself writes.

#include <string>
#include <vector>

#include "book/tool/page.hpp"

namespace tumble::book {

/// The page with these numbers counted anew; as it is where the list is missing.
Page with_fresh_counts(const fs::path& root, const Page& page);

/// The numbers that have changed: "file:line: …" each.
std::vector<std::string> stale_counts(const fs::path& root, const Page& page);

}  // namespace tumble::book
