// The colours of figures, seen by eyes that lack one kind of cones, and read as text.
#include "support/palette.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "project/harness/refusal.hpp"
#include "support/series_looks.hpp"
#include "tumble/core/types.hpp"

using namespace tumble;
using namespace tumble::support;

namespace {

/// Linear red, green and blue of "#rrggbb", each 0 … 1 (IEC 61966-2-1).
Vec3 linear_rgb(std::string_view hex) {
  Vec3 rgb;
  for (int i = 0; i < 3; ++i) {
    const std::string two(hex.substr(1 + 2 * static_cast<std::size_t>(i), 2));
    const double c = std::stoi(two, nullptr, 16) / 255.0;
    rgb[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return rgb;
}

/// CIE L*a*b* for daylight D65.
Vec3 lab(const Vec3& rgb) {
  Mat3 to_xyz;
  to_xyz << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920,
      0.9503041;
  const Vec3 xyz = (to_xyz * rgb).cwiseQuotient(Vec3(0.95047, 1, 1.08883));
  const auto f = [](double t) {
    return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  };
  return {116 * f(xyz[1]) - 16, 500 * (f(xyz[0]) - f(xyz[1])), 200 * (f(xyz[1]) - f(xyz[2]))};
}

/// What an eye makes of linear colours (Machado, Oliveira & Fernandes, IEEE Trans. Vis. Comput.
/// Graph. 15 (2009) 1291–1298, severity 1).
struct Eye {
  const char* name;
  Mat3 sees;
};

std::array<Eye, 3> eyes() {
  Mat3 no_red, no_green;
  no_red << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116,
      1.051998;
  no_green << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940,
      0.968881;
  return {{{"all cones", Mat3::Identity()}, {"protanopia", no_red}, {"deuteranopia", no_green}}};
}

double difference(const Eye& eye, std::string_view a, std::string_view b) {
  const auto seen = [&eye](std::string_view hex) {
    return lab((eye.sees * linear_rgb(hex)).cwiseMax(0).cwiseMin(1));
  };
  return (seen(a) - seen(b)).norm();
}

/// As WCAG 2 has it: from 1 to 21.
double contrast(std::string_view a, std::string_view b) {
  const auto luminance = [](std::string_view hex) {
    return Vec3(0.2126, 0.7152, 0.0722).dot(linear_rgb(hex)) + 0.05;
  };
  const double x = luminance(a), y = luminance(b);
  return std::max(x, y) / std::min(x, y);
}

}  // namespace

TEST_CASE("palette: the measure is right where others have published it") {
  CHECK(contrast("#000000", "#ffffff") == doctest::Approx(21));
  CHECK((lab(linear_rgb("#ff0000")) - Vec3(53.24, 80.09, 67.20)).norm() < 0.02);
}

TEST_CASE("palette: any two colours of curves stay apart, whatever cones an eye has") {
  constexpr double apart = 12;  // two thin lines of less are one
  for (const auto mode : {&Paint::light, &Paint::dark})
    for (const Eye& eye : eyes())
      for (std::size_t i = 0; i < series_colours; ++i)
        for (std::size_t j = 0; j < i; ++j) {
          CAPTURE(eye.name);
          CAPTURE(palette[i].name);
          CAPTURE(palette[j].name);
          CHECK(difference(eye, palette[i].*mode, palette[j].*mode) > apart);
        }
}

TEST_CASE("palette: names of curves and other words can be read") {
  for (const Paint& each : palette) {
    if (each.name == "paper" || each.name == "grid" || each.name == "solid") continue;
    CAPTURE(each.name);
    CHECK(contrast(each.light, paint("paper").light) > 4.5);
    CHECK(contrast(each.dark, paint("paper").dark) > 4.5);
  }
}

TEST_CASE("palette: each colour has an attribute of its own, and a variable over it") {
  const std::string style = figure_style();
  for (const Paint& each : palette) {
    CHECK(std::count_if(palette.begin(), palette.end(),
                        [&](const Paint& other) { return other.light == each.light; }) == 1);
    CHECK(style.find("[" + fill_of(each.name) + "]{fill:var(--" + std::string(each.name) + ")}") !=
          std::string::npos);
  }
  CHECK_REFUSED(fill_of("c10"), "c10");
}

TEST_CASE(
    "looks: what the book knows has its colour, the rest what is left, and no two look alike") {
  CHECK(known_colour("backward Euler") != known_colour("Euler, 240 steps/s"));
  CHECK(known_colour("your RK4") == known_colour("RK4"));
  CHECK(known_colour("breakfast").empty());
  const std::vector<SeriesLook> looks =
      series_looks({{"mine", {}, {}}, {"RK4, nine", {}, {}}, {"RK4, four", {}, {}}, {"b", {}, {}}});
  CHECK(looks[1].colour == looks[2].colour);
  CHECK(looks[0].colour != looks[1].colour);
  CHECK(looks[3].colour != looks[0].colour);
  for (std::size_t i = 0; i < looks.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) CHECK(looks[i].marker != looks[j].marker);
}
