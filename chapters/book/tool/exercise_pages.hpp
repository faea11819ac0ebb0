#pragma once
/// @file
/// The page of a chapter's exercises, made of its contract and its hints.

#include "book/tool/page.hpp"

namespace tumble::book {

/// Every exercise of the chapter with its task, its signature, its hints one at a time, and links
/// to where the chapter derives it, to its specification, and to a solution where there is one.
/// @param folder exercises/NN_name
/// @return a page exercises/NN_name/README.md, which is in no folder
Page exercise_page(const fs::path& root, const fs::path& folder);

}  // namespace tumble::book
