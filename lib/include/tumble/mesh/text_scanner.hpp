#pragma once
/// @file
/// A text in memory, read word by word.

#include <string>
#include <string_view>

#include "tumble/core/require.hpp"
#include "tumble/mesh/eight_bytes.hpp"

namespace tumble::detail {

inline bool is_blank(char c) { return c == ' ' || c == '\t'; }
inline bool is_newline(char c) { return c == '\n' || c == '\r'; }

/// Whether a word is this keyword; capitals do not matter.
bool is_keyword(std::string_view word, std::string_view keyword);

/// A text without what some programs fill it up with behind its end: bytes 0, and the mark with
/// which DOS ended a text; blanks may be between these.
std::string_view without_padding(std::string_view text);

/// Lines end with \n, \r\n, or (on old machines) \r; words with a space, a tab or their line. A
/// byte order mark is passed over.
class TextScanner {
 public:
  TextScanner(std::string_view text, std::string_view name) : name_(name) {
    take(text);
    if (text.starts_with("\xEF\xBB\xBF")) at_ += 3;
  }

  /// Goes on with what follows a text that was read to its end, which was the end of a line.
  void take(std::string_view text) {
    at_ = text.data();
    end_ = at_ + text.size();
  }

  const char* at() const { return at_; }
  const char* end() const { return end_; }
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }
  void move_to(const char* at) { at_ = at; }

  bool at_end() const { return at_ == end_; }
  bool at_line_end() const { return at_ == end_ || is_newline(*at_); }
  bool ends_word(const char* at) const { return at == end_ || is_blank(*at) || is_newline(*at); }

  void skip_blanks() {
    while (at_ != end_ && is_blank(*at_)) ++at_;
  }
  /// Goes to the next word, in this line or a later one.
  void skip_to_word() {
    for (skip_blanks(); !at_end() && at_line_end(); skip_blanks()) next_line();
  }

  /// The rest of the line; stops at its end.
  std::string_view rest_of_line() {
    const char* const begin = at_;
    while (!at_line_end()) ++at_;
    return {begin, static_cast<std::size_t>(at_ - begin)};
  }

  void skip_to_line_end() {
    // Of what is less than \r, only \n ends a line; the rest is rare.
    while (!at_line_end()) at_ = find_below(at_ + 1, end_, '\r' + 1);
  }
  /// Goes to the beginning of the next line.
  void next_line() {
    skip_to_line_end();
    if (at_ == end_) return;
    const bool carriage_return = *at_++ == '\r';
    if (carriage_return && at_ != end_ && *at_ == '\n') ++at_;
    ++line_;
  }

  /// The word that begins here, which is not passed over: empty at a blank or the end of a line.
  std::string_view peek_word() const {
    const char* at = at_;
    while (!ends_word(at)) ++at;
    return {at_, static_cast<std::size_t>(at - at_)};
  }

  /// The next word of this line, passed over: empty if there is none.
  std::string_view next_word() {
    skip_blanks();
    const std::string_view word = peek_word();
    at_ += word.size();
    return word;
  }

  /// Refuses the text because of what is in this line.
  /// @throws std::invalid_argument naming the line
  template <class... Parts>
  [[noreturn]] void refuse(const Parts&... message) const {
    detail::refuse(name_, ", line ", line_, ": ", message...);
  }

 private:
  const char *at_ = nullptr, *end_ = nullptr;
  std::size_t line_ = 1;
  std::string_view name_;
};

/// A word as it can be shown: its beginning, if it is long; \x00 for a byte that is not a letter.
std::string shown(std::string_view word);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/text_scanner.inl"
#endif
