#pragma once
/// @file
/// Boxes with words in them, and arrows with words beside them: how something goes.

#include <string>

#include "support/sketch.hpp"

namespace tumble::support {

/// A box with a title and the line below it.
inline void box(Sketch& sketch, const Vec2& low, const Vec2& high, const std::string& title,
                const std::string& below, const std::string& colour) {
  sketch.frame(low, high, {colour, 1.8, 1, 0.08});
  const Vec2 middle = (low + high) / 2;
  sketch.words(middle, {0, below.empty() ? 6. : -4.}, title, "ink", "middle");
  if (!below.empty()) sketch.words(middle, {0, 18}, below, colour, "middle");
}

/// An arrow and the words beside it.
inline void flow(Sketch& sketch, const Vec2& from, const Vec2& to, const Vec2& offset,
                 const std::string& words, const std::string& anchor = "middle") {
  sketch.arrow(from, to, {"ink", 1.8});
  sketch.words((from + to) / 2, offset, words, "ink", anchor);
}

}  // namespace tumble::support
