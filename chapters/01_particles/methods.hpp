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

}  // namespace particles_chapter
