#pragma once
/// @file
/// A part of the mild orbit in equal steps, and the error at its end.

#include "problems.hpp"
#include "tumble/ode.hpp"

namespace solvers_chapter {

inline const double order_time = 0.4 * mild.period();

template <class Method>
Vec4 mild_end(int steps) {
  return integrate_fixed<Method>(SunsPull{}, mild.at(0), 0.0, order_time, steps);
}

inline double mild_error(const Vec4& y) { return (y - mild.at(order_time)).norm(); }

}  // namespace solvers_chapter
