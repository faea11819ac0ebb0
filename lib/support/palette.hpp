#pragma once
/// @file
/// The colours of every figure, for light and for dark. A figure writes the light colour as a plain
/// attribute, which any viewer understands; a style sheet puts a variable over it, which follows
/// the page.

#include <array>
#include <string>
#include <string_view>

#include "tumble/core/require.hpp"

namespace tumble::support {

/// A colour by its name, as "#rrggbb".
struct Paint {
  std::string_view name, light, dark;
};

/// How many colours there are for what is compared: "c0" … "c9".
constexpr std::size_t series_colours = 10;

/// Any two of c0 … c9 stay apart for eyes without red or without green cones, and each can be read
/// as text. A test computes both.
inline constexpr std::array<Paint, 15> palette{{{"c0", "#0c62a8", "#68b0eb"},
                                                {"c1", "#bd5403", "#fc9756"},
                                                {"c2", "#087852", "#5cdfb1"},
                                                {"c3", "#8a2b77", "#d381bf"},
                                                {"c4", "#8d6d33", "#e8be41"},
                                                {"c5", "#636772", "#b1b3bb"},
                                                {"c6", "#ac1c10", "#f67464"},
                                                {"c7", "#2b7b9c", "#60c9e5"},
                                                {"c8", "#6e4d30", "#cfac85"},
                                                {"c9", "#5a4ec2", "#9a98ff"},
                                                {"paper", "#ffffff", "#0d1117"},
                                                {"ink", "#1c2128", "#e2e8ee"},
                                                {"faint", "#68717b", "#99a2ac"},
                                                {"grid", "#e6e9ed", "#353d47"},
                                                {"solid", "#b9c7d8", "#5f7793"}}};

/// @throws std::invalid_argument if there is no such colour
inline const Paint& paint(std::string_view name) {
  for (const Paint& each : palette)
    if (each.name == name) return each;
  require(false, "no colour of figures is called '", name, "'");
  return palette.front();
}

inline std::string fill_of(std::string_view name) {
  return "fill=\"" + std::string(paint(name).light) + "\"";
}

inline std::string stroke_of(std::string_view name) {
  return "stroke=\"" + std::string(paint(name).light) + "\"";
}

namespace palette_detail {

/// The variables of one mode, as `--c0:#…;`.
inline std::string variables(std::string_view Paint::*mode) {
  std::string css;
  for (const Paint& each : palette)
    css += "--" + std::string(each.name) + ":" + std::string(each.*mode) + ";";
  return css;
}

/// Where a plain attribute has the light colour, the variable is put over it.
inline std::string over_attributes() {
  std::string css;
  for (const Paint& each : palette)
    for (const std::string property : {"fill", "stroke"})
      css += ".tumble-figure [" + property + "=\"" + std::string(each.light) + "\"]{" + property +
             ":var(--" + std::string(each.name) + ")}\n";
  return css;
}

}  // namespace palette_detail

/// The style of a figure. It is dark where the viewer or the page is; in a page it is on the
/// page, without paper of its own.
inline std::string figure_style() {
  using namespace palette_detail;
  const std::string dark = "{" + variables(&Paint::dark) + "}";
  return ".tumble-figure{" + variables(&Paint::light) +
         "font:13px system-ui,-apple-system,'Segoe UI',Roboto,'DejaVu Sans',sans-serif;"
         "max-width:100%;height:auto}\n"
         "@media (prefers-color-scheme:dark){html:not(.light-mode) "
         ".tumble-figure,.tumble-figure:root" +
         dark + "}\nhtml.dark-mode .tumble-figure" + dark + "\n" + over_attributes() +
         "html .tumble-figure{--paper:var(--page-background-color,Canvas)}\n"
         "html .tumble-figure>.paper{fill:none}\n";
}

}  // namespace tumble::support
