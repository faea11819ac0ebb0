#pragma once
/// @file
/// Whether the pages are true: code, numbers, formulas, figures and links.

#include <filesystem>
#include <string>
#include <vector>

#include "book/tool/sources.hpp"

namespace tumble::book {

/// The pages of the book: the front page, and those in the folders of chapters/, a folder's
/// README.md first.
std::vector<fs::path> pages_of(const fs::path& root);

/// What is wrong with the pages, "file:line: …" each.
std::vector<std::string> mistakes_in(const Places& places);

/// The page of terms, as the other pages' bold type says it.
Page fresh_terms(const fs::path& root);

}  // namespace tumble::book
