#pragma once
/// @file
/// The pieces that every figure shares: numbers and text as SVG wants them, and one style for light
/// and dark that works as a file of its own and inlined in a page.

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

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
         "\">\n<title>" + svg_text(title) + R"svg(</title>
<style>
.tumble-figure{--paper:#fff;--ink:#1c2128;--faint:#8b949e;--grid:#e6e9ed;--solid:#b9c7d8;
--c0:#0b62a8;--c1:#c4500a;--c2:#0f7b55;--c3:#9b3a86;--c4:#8a6a00;--c5:#5a6472;--c6:#b3261e;--c7:#2f7f93;--c8:#7a5c3e;--c9:#5b4fc4;
font:13px system-ui,-apple-system,'Segoe UI',Roboto,'DejaVu Sans',sans-serif;max-width:100%;height:auto}
@media (prefers-color-scheme:dark){html:not(.light-mode) .tumble-figure,.tumble-figure:root{--paper:#0d1117;
--ink:#e2e8ee;--faint:#7d8590;--grid:#262c34;--solid:#5f7793;
--c0:#58aef0;--c1:#ff9a57;--c2:#4cc79a;--c3:#e28fcd;--c4:#e0bb46;--c5:#a7b1bd;--c6:#ff7b72;--c7:#6cc5d9;--c8:#d0a87c;--c9:#a99cff}}
html.dark-mode .tumble-figure{--paper:#0d1117;--ink:#e2e8ee;--faint:#7d8590;--grid:#262c34;--solid:#5f7793;
--c0:#58aef0;--c1:#ff9a57;--c2:#4cc79a;--c3:#e28fcd;--c4:#e0bb46;--c5:#a7b1bd;--c6:#ff7b72;--c7:#6cc5d9;--c8:#d0a87c;--c9:#a99cff}
</style>
<rect width="100%" height="100%" fill="var(--paper)"/>
)svg";
}

}  // namespace tumble::support
