#pragma once
/// @file
/// Page numbers in the printed book's contents. Browsers don't know `target-counter`, so the book
/// is printed twice: the first time says on which page each place is.

#include <map>
#include <string>

namespace tumble::book {

/// The page of each named place in a PDF that Chromium has printed, from 1.
std::map<std::string, int> pages_of_places(const std::string& pdf);

/// The printed book with the numbers of pages behind the entries of its contents.
/// @throws std::invalid_argument if an entry leads to no place
std::string with_page_numbers(const std::string& html, const std::map<std::string, int>& pages);

}  // namespace tumble::book
