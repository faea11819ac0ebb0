#pragma once
/// @file
/// The pieces that every figure shares: numbers and text as SVG wants them, and an opening that
/// works as a file of its own and inlined in a page.

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "support/palette.hpp"
#include "tumble/core/require.hpp"

namespace tumble::support {

/// A number with at most `digits` behind the point, without trailing zeros, the same
/// on every platform.
inline std::string svg_number(double value, int digits = 1) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::fixed, digits);
  require(std::isfinite(value) && end.ec == std::errc{}, "a figure cannot show the number ", value);
  std::string s(text.data(), end.ptr);
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
