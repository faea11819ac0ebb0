#pragma once
/// @file
/// A body by its name.

#include <algorithm>

#include "scenes/scene.hpp"
#include "support/place.hpp"
#include "support/printable.hpp"

namespace tumble::scenes {

/// The number of the body that is named there.
/// @throws std::invalid_argument if there is none of that name
inline std::size_t find_body(const support::Place& place, const std::vector<SceneBody>& bodies) {
  const std::string name = place.text();
  const auto found = std::find_if(bodies.begin(), bodies.end(),
                                  [&](const SceneBody& body) { return body.name == name; });
  require(found != bodies.end(), place.name(), ": there is no body \"", support::escaped(name),
          "\"");
  return static_cast<std::size_t>(found - bodies.begin());
}

}  // namespace tumble::scenes
