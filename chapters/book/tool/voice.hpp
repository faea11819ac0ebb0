#pragma once
/// @file
/// Whether a page speaks to its reader: you and we, and none of the idioms that make a sentence
/// hard to read.

#include <string>
#include <vector>

#include "book/tool/page.hpp"

namespace tumble::book {

/// An idiom, and what to write instead.
struct Idiom {
  std::string words, instead;
};

/// Lines "idiom = instead"; lines that begin with # are comments.
/// @throws PageError if a line is neither, or the file cannot be read
std::vector<Idiom> read_idioms(const fs::path& file);

/// "you", "we" and their forms in a thousand words of prose; the sources of a page do not count.
double you_and_we(const Page& page);

/// "file:line: …" for each idiom, and for a page with fewer than 12 in a thousand. Of a page that a
/// command writes from sentences of elsewhere, nothing is asked.
std::vector<std::string> mistakes_of_voice(const Page& page, const std::vector<Idiom>& idioms);

}  // namespace tumble::book
