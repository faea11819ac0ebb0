#pragma once
/// @file
/// Links of the finished site that lead nowhere.

#include <string>
#include <vector>

#include "book/tool/page.hpp"

namespace tumble::book {

/// Every href and src of every page below `folder` that names no file, or a place that its page
/// does not have: "page.html: file.html#place" each. Addresses with a scheme (https:) are not
/// followed.
std::vector<std::string> dead_ends(const fs::path& folder);

}  // namespace tumble::book
