#pragma once
/// @file
/// The three methods of the chapter, one after the other.

#include <string>

#include "tumble/ode.hpp"

namespace particles_chapter {

using namespace tumble;

/// Calls visit(name, method, evaluations of the right-hand side in a step).
template <class Visit>
void for_each_method(Visit&& visit) {
  visit("Euler", runge_kutta::Euler{}, 1);
  visit("midpoint", runge_kutta::Midpoint{}, 2);
  visit("RK4", Rk4{}, 4);
}

/// The colour of a method in the drawings: that of its curve in the plots, where the three stand in
/// the same order.
inline std::string colour_of(const std::string& method) {
  return method == "Euler" ? "c0" : method == "midpoint" ? "c1" : "c2";
}

}  // namespace particles_chapter
