#pragma once
/// @file
/// Which colour and which marker a curve gets. What the book draws more than once has its own
/// colour everywhere; and since not all eyes see colours, no two curves of a plot look alike
/// without them.

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/palette.hpp"
#include "support/series.hpp"

namespace tumble::support {

/// The colour and the marker of a curve. Markers 0 … 4 are full, 5 … 9 the same shapes, open.
struct SeriesLook {
  std::string colour;
  int marker;
};

constexpr int marker_shapes = 5, markers = 2 * marker_shapes;

namespace looks_detail {

using Known = std::pair<std::string_view, std::string_view>;

/// Words in the names of curves, and their colour through the whole book. If several are in a name,
/// the longest decides.
inline constexpr std::array<Known, 54> known{{{"Euler", "c1"},
                                              {"midpoint", "c2"},
                                              {"RK4", "c0"},
                                              {"DP 5(4)", "c3"},
                                              {"Dormand–Prince 5(4)", "c3"},
                                              {"DOP853", "c4"},
                                              {"Dormand–Prince 8(5,3)", "c4"},
                                              {"backward Euler", "c6"},
                                              {"Radau", "c7"},
                                              {"Radau5", "c7"},
                                              {"Taylor", "c5"},
                                              {"closed form", "c8"},
                                              {"momenta first", "c9"},
                                              {"splitting", "c9"},
                                              {"simulate", "c6"},
                                              {"along the axes", "c0"},
                                              {"oriented box", "c2"},
                                              {"smaller", "c2"},
                                              {"box of the true volume", "c8"},
                                              {"box of the true mass", "c8"},
                                              {"random points", "c3"},
                                              {"grid points", "c4"},
                                              {"R3 points", "c6"},
                                              {"stratified points", "c1"},
                                              {"columns", "c5"},
                                              {"jittered columns", "c5"},
                                              {"grid columns", "c9"},
                                              {"Mirtich", "c9"},
                                              {"textbook", "c9"},
                                              {"tetrahedra", "c1"},
                                              {"fast", "c1"},
                                              {"tight", "c7"},
                                              {"tetrahedra, tight", "c7"},
                                              {"least", "c0"},
                                              {"middle", "c1"},
                                              {"largest", "c2"},
                                              {"tumble", "c0"},
                                              {"Boost.odeint", "c1"},
                                              {"SUNDIALS", "c2"},
                                              {"Simbody", "c3"},
                                              {"MuJoCo", "c4"},
                                              {"Bullet", "c7"},
                                              {"ODE", "c6"},
                                              {"Gram–Schmidt", "c7"},
                                              {"Newton step", "c8"},
                                              {"nearest rotation", "c9"},
                                              {"slerp", "c0"},
                                              {"nine numbers", "c1"},
                                              {"four numbers", "c2"},
                                              {"three angles", "c3"},
                                              {"by the origin", "c0"},
                                              {"by way of the origin", "c0"},
                                              {"differences", "c1"},
                                              {"differences first", "c1"}}};

inline bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

/// Whether the words are in the name by themselves, not as a part of longer ones.
inline bool has_words(std::string_view name, std::string_view words) {
  for (std::size_t at = name.find(words); at != std::string_view::npos;
       at = name.find(words, at + 1)) {
    const std::size_t end = at + words.size();
    if ((at == 0 || !is_letter(name[at - 1])) && (end == name.size() || !is_letter(name[end])))
      return true;
  }
  return false;
}

/// The first colour that no curve has; if all are taken, they begin again.
inline std::string free_colour(const std::vector<std::string>& taken, std::size_t index) {
  for (std::size_t i = 0; i < series_colours; ++i) {
    const std::string colour = "c" + std::to_string(i);
    if (std::find(taken.begin(), taken.end(), colour) == taken.end()) return colour;
  }
  return "c" + std::to_string(index % series_colours);
}

}  // namespace looks_detail

/// The colour that the book gives to what is named, or nothing.
inline std::string known_colour(std::string_view name) {
  using namespace looks_detail;
  Known found{"", ""};
  for (const Known& each : known)
    if (each.first.size() > found.first.size() && has_words(name, each.first)) found = each;
  return std::string(found.second);
}

/// The looks of a plot's curves: first what is given or known, then the colours that are left. A
/// colour brings its marker; the next curve of that colour has another one.
inline std::vector<SeriesLook> series_looks(const std::vector<Series>& series) {
  using namespace looks_detail;
  std::vector<std::string> colours;
  for (const Series& each : series)
    colours.push_back(each.colour.empty() ? known_colour(each.name) : each.colour);
  for (std::size_t i = 0; i < colours.size(); ++i)
    if (colours[i].empty()) colours[i] = free_colour(colours, i);
  std::vector<SeriesLook> looks;
  std::array<bool, markers> taken{};
  for (const std::string& colour : colours) {
    int marker = (colour[0] == 'c' ? colour[1] - '0' : 0) % markers;
    for (int tries = 0; tries < markers && taken[static_cast<std::size_t>(marker)]; ++tries)
      marker = (marker + (tries % 2 == 0 ? marker_shapes : marker_shapes + 1)) % markers;
    taken[static_cast<std::size_t>(marker)] = true;
    looks.push_back({colour, marker});
  }
  return looks;
}

}  // namespace tumble::support
