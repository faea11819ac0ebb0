#pragma once
/// @file
/// A drawing that moves by itself, wherever SVG is shown.

#include "support/sketch.hpp"

namespace tumble::support {

/// Shows pictures one after the other, again and again. Where less motion is asked for, on paper,
/// and in viewers without CSS animations the first one stands still.
/// @param count   how many
/// @param seconds from the first picture to the first again
/// @param draw    draw(i) adds picture i to the sketch
template <class Draw>
void flipbook(Sketch& sketch, int count, double seconds, const Draw& draw) {
  sketch.drawing(
      "<style>\n.flipbook>g{visibility:hidden}\n.flipbook>g:first-child{visibility:visible}\n"
      "@media screen and (prefers-reduced-motion:no-preference){.flipbook>g{animation:flipbook " +
      svg_number(seconds, 2) + "s infinite}}\n@keyframes flipbook{0%{visibility:visible}" +
      svg_number(100.0 / count, 3) +
      "%,100%{visibility:hidden}}\n</style>\n<g class=\"flipbook\">\n");
  for (int i = 0; i < count; ++i) {
    const double since = seconds * (i - count) / count;
    sketch.drawing("<g style=\"animation-delay:" + svg_number(since, 3) + "s\">\n");
    draw(i);
    sketch.drawing("</g>\n");
  }
  sketch.drawing("</g>\n");
}

}  // namespace tumble::support
