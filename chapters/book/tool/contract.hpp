#pragma once
/// @file
/// A chapter's contract and its hints: what they say, what is given, and the exercises.

#include <string>
#include <vector>

#include "book/tool/page.hpp"

namespace tumble::book {

struct ContractPart {
  std::string number, name, title;  ///< "9.1", "pack", "a state becomes thirteen numbers"
  std::string task;                 ///< the comment as Markdown, its parameters as a list
  std::string code;                 ///< the declarations
};

struct Contract {
  std::string introduction;  ///< the comment on the file, without its first paragraph
  std::string types;         ///< what is above the first exercise
  std::vector<ContractPart> parts;
};

/// @throws PageError if it cannot be read
Contract read_contract(const fs::path& file);

using Hint = std::vector<std::string>;  ///< its lines

/// All hints of hints.md to an exercise, in order; none if it has none.
/// @throws PageError if the file cannot be read
std::vector<Hint> hints_of(const fs::path& file, const std::string& number);

/// "a state becomes …" → "A state becomes …."
std::string as_sentence(std::string title);

/// Lines of a documenting comment as Markdown: "@param x a number" is an item of a list.
std::string markdown_of_comment(const std::vector<std::string>& lines);

}  // namespace tumble::book
