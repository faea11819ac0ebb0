/// @file
/// What the arithmetic of an orientation costs, in operations.

#include "counted_steps.hpp"
#include "parts.hpp"
#include "support/stopwatch.hpp"
#include "tumble/ode.hpp"

namespace quaternions_chapter {

Table counts_table() {
  Table table({"what", "four numbers", "nine numbers"});
  const Quaternion<Counted>& q = counted_q;
  const Vector3<Counted>& v = counted_v;
  const Matrix3<Counted> R = to_matrix(q);
  const auto count = [](auto&& action) {
    return text_of(support::count([&] { support::keep(action()); }));
  };
  table.add({"compose two", count([&] { return Quaternion<Counted>(q * q); }),
             count([&] { return Matrix3<Counted>(R * R); })});
  table.add({"turn a point", count([&] { return Vector3<Counted>(q * v); }),
             count([&] { return Vector3<Counted>(R * v); })});
  table.add({"rate of change", count([&] { return rotation::quaternion_dot<Counted>(q, v); }),
             count([&] { return rotation::rotation_dot<Counted>(R, v); })});
  table.add({"one step of Euler", text_of(step_of_four<runge_kutta::Euler>()),
             text_of(step_of_nine<runge_kutta::Euler>())});
  table.add({"one step of midpoint", text_of(step_of_four<runge_kutta::Midpoint>()),
             text_of(step_of_nine<runge_kutta::Midpoint>())});
  table.add({"one step of RK4", text_of(step_of_four<Rk4>()), text_of(step_of_nine<Rk4>())});
  table.add({"normalise", count([&] { return q.normalized(); }), ""});
  table.add({"turn into a matrix", count([&] { return to_matrix(q); }), ""});
  return table;
}

}  // namespace quaternions_chapter
