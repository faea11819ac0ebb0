#pragma once
/// @file
/// The text of a source file as code: what a compiler reads of it, and its words.

#include <cstddef>
#include <string>

namespace tumble::judge {

/// The code without what the compiler skips: each character of a comment, of a text or behind
/// #if 0 is a blank.
std::string code_of(const std::string& source);

/// Whether the code of `source` contains `word`: not in comments, texts, or as a part of another
/// word.
bool mentions(const std::string& source, const std::string& word);

/// Whether this text of code contains this word, not as a part of another.
bool has_word(const std::string& code, const std::string& word);

/// Whether words have such a character.
bool is_of_word(char c);

/// The line of this number, from 1; empty if there is none.
std::string code_line(const std::string& code, std::size_t number);

/// The number of the line, from 1, that holds this character.
std::size_t line_of(const std::string& code, std::size_t at);

}  // namespace tumble::judge
