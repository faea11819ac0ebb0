#pragma once
/// @file
/// The pieces that every figure shares: numbers and text as SVG wants them, and an opening that
/// works as a file of its own and inlined in a page.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "support/palette.hpp"
#include "tumble/core/require.hpp"

namespace tumble::support {

/// A number with `digits` behind the point, rounded as it is exactly, ties to even. The standard's
/// function does the same with a table of 100 KB, too much for a page that draws its own figures.
/// @param digits 0 … 15
/// @throws std::invalid_argument unless |value| 10^digits < 2^52
inline std::string fixed_text(double value, int digits) {
  constexpr std::array<double, 16> powers{1,   10,  100,  1e3,  1e4,  1e5,  1e6,  1e7,
                                          1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const double power = powers.at(static_cast<std::size_t>(digits)), size = std::abs(value);
  const double scaled = size * power, rest = std::fma(size, power, -scaled);
  require(scaled < 0x1p52, "a figure cannot show the number ", value);
  auto units = static_cast<std::uint64_t>(scaled);
  const double over = scaled - static_cast<double>(units) - 0.5 + rest;
  if (over > 0 || (over == 0 && units % 2 == 1)) ++units;
  std::string text;  // from its end
  for (int i = 0; i <= digits || units > 0; ++i, units /= 10) {
    if (i == digits && digits > 0) text += '.';
    text += static_cast<char>('0' + units % 10);
  }
  if (std::signbit(value)) text += '-';
  return {text.rbegin(), text.rend()};
}

/// A number with at most `digits` behind the point, without trailing zeros, the same
/// on every platform.
inline std::string svg_number(double value, int digits = 1) {
  std::string s = fixed_text(value, digits);
  if (s.find('.') != std::string::npos) {
    s.erase(s.find_last_not_of('0') + 1);
    if (s.back() == '.') s.pop_back();
  }
  return s == "-0" ? "0" : s;
}

/// Text with the characters that XML reserves escaped.
inline std::string svg_text(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else
      escaped += c;
  }
  return escaped;
}

/// Text, escaped, in which a number below zero has its minus sign, and no hyphen.
inline std::string svg_minus_signs(std::string_view words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const bool begins = i == 0 || words[i - 1] == ' ' || words[i - 1] == '(';
    const bool number = i + 1 < words.size() && words[i + 1] >= '0' && words[i + 1] <= '9';
    if (words[i] == '-' && begins && number)
      text += "−";
    else
      text += words[i];
  }
  return svg_text(text);
}

/// About how wide words of this size are drawn: the same with every font, or figures would differ.
inline double text_width(std::string_view words, double size = 13) {
  const auto starts_letter = [](char c) { return (c & 0xC0) != 0x80; };
  return 7.0 / 13 * size *
         static_cast<double>(std::count_if(words.begin(), words.end(), starts_letter));
}

/// A Latin letter, or a byte of a Greek one in UTF-8.
inline bool is_letter(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (byte & 0xFEU) == 0xCEU ||
         (byte & 0xC0U) == 0x80U;
}

inline bool is_subscript(char c) { return is_letter(c) || (c >= '0' && c <= '9'); }

/// Where the `_` of a symbol is, that of p_body: after one letter. Names of the code have more.
/// @return the end of the words if there is none
inline std::size_t subscript_mark(std::string_view words) {
  for (std::size_t i = 1; i + 1 < words.size(); ++i) {
    if (words[i] != '_' || !is_letter(words[i - 1]) || !is_subscript(words[i + 1])) continue;
    const bool greek = (static_cast<unsigned char>(words[i - 1]) & 0x80U) != 0;
    const std::size_t letter = i - (greek ? 2 : 1);
    if (letter == 0 || !is_letter(words[letter - 1])) return i;
  }
  return words.size();
}

/// Words of a picture, escaped: with minus signs, and lowered subscripts.
inline std::string svg_words(std::string_view words) {
  const std::size_t mark = subscript_mark(words);
  std::string text = svg_minus_signs({words.data(), mark});
  if (mark == words.size()) return text;
  std::size_t end = mark + 1;
  while (end < words.size() && is_subscript(words[end])) ++end;
  text += "<tspan dy=\"3\" font-size=\"75%\">";
  text.append(words.data() + mark + 1, end - mark - 1);
  text += "</tspan>";
  if (end == words.size()) return text;
  words.remove_prefix(end);
  text += "<tspan dy=\"-3\">";
  text += svg_words(words);
  text += "</tspan>";
  return text;
}

/// The opening of a figure: size, title for screen readers, style, background. Close
/// it with </svg>.
inline std::string svg_open(double width, double height, std::string_view title) {
  const std::string size = svg_number(width) + " " + svg_number(height);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"tumble-figure\" role=\"img\" "
         "viewBox=\"0 0 " +
         size + "\" width=\"" + svg_number(width) + "\" height=\"" + svg_number(height) +
         "\">\n<title>" + svg_text(title) + "</title>\n<style>\n" + figure_style() +
         "</style>\n<rect class=\"paper\" width=\"100%\" height=\"100%\" " + fill_of("paper") +
         "/>\n";
}

}  // namespace tumble::support
