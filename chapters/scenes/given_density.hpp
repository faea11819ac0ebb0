#pragma once
/// @file
/// What --density says: a number for all, or NAME=NUMBER for each part.

#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "tumble/core/require.hpp"
#include "tumble/mass/parts/split.hpp"

namespace tumble::scenes {

/// One of the two, or neither.
struct GivenDensity {
  std::optional<double> of_all;  ///< [kg/m³]
  parts::Densities of_parts;
};

/// @param texts what was given, each time
/// @throws std::invalid_argument if a text is neither, or they contradict each other
inline GivenDensity given_density(const std::vector<std::string>& texts) {
  GivenDensity given;
  for (const std::string& text : texts) {
    // A name may have an equals sign in it, a number has none.
    const std::size_t sign = text.rfind('=');
    const bool named = sign != std::string::npos;
    const std::string name = named ? text.substr(0, sign) : "";
    const std::string number = named ? text.substr(sign + 1) : text;
    char* end = nullptr;
    const double density = std::strtod(number.c_str(), &end);
    require(!number.empty() && *end == 0 && (!named || !name.empty()), "--density takes a number ",
            "of kg/m³, or NAME=NUMBER, and not \"", text, "\"");
    if (named) {
      require(given.of_parts.emplace(name, density).second, "\"", name,
              "\" has two densities: ", "give one");
    } else {
      require(!given.of_all, "there are two densities: give one, or a name with each of them, ",
              "NAME=NUMBER");
      given.of_all = density;
    }
  }
  require(!given.of_all || given.of_parts.empty(), "there is a density for all, and one for \"",
          given.of_parts.empty() ? "" : given.of_parts.begin()->first,
          "\": with one name, every part needs its own, NAME=NUMBER");
  return given;
}

}  // namespace tumble::scenes
