#pragma once
/// @file
/// The words of an OBJ text: a line goes on in the next one behind a backslash, and ends at a #.

#include <string_view>

#include "tumble/mesh/text_scanner.hpp"

namespace tumble::detail {

class ObjText : public TextScanner {
 public:
  using TextScanner::TextScanner;

  /// Whether the line begins with this keyword, here.
  bool begins_with(char keyword) const {
    return !at_end() && *at() == keyword && ends_word(at() + 1);
  }

  /// Where there are no more words: at the end of the line, or at a comment.
  bool at_last_word() const { return at_line_end() || *at() == '#'; }

  /// Whether a number ends here. A comment may follow it without a blank: no number has a # in it.
  bool ends_number(const char* at) const { return ends_word(at) || *at == '#' || continues(at); }

  /// Goes to the next word of the line, and of those that it goes on in.
  void skip_to_next_word() {
    for (skip_blanks(); continues(at()); skip_blanks()) {
      move_to(at() + 1);
      next_line();
    }
  }

  /// Passes over what is left of a line that has begun, and over those that it goes on in.
  void pass_over_line() {
    for (skip_to_line_end(); !at_end() && at()[-1] == '\\'; skip_to_line_end()) next_line();
  }

  /// What is left of the line, without the blanks around it: names have blanks in them, and number
  /// signs.
  std::string_view next_name() {
    skip_blanks();
    std::string_view name = rest_of_line();
    while (!name.empty() && is_blank(name.back())) name.remove_suffix(1);
    return name;
  }

 private:
  /// Whether a line goes on in the next one here: at a backslash that is its last letter.
  bool continues(const char* at) const {
    return at != end() && *at == '\\' && (at + 1 == end() || is_newline(at[1]));
  }
};

}  // namespace tumble::detail
