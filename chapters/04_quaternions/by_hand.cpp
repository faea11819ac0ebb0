/// @file
/// Products and turns with numbers that fit on paper, and how slowly RK4 shortens a quaternion.

#include "common.hpp"
#include "parts.hpp"
#include "rates.hpp"

namespace quaternions_chapter {

namespace {

const Quat about_x = from_axis_angle(Vec3::UnitX(), 90 * degree),
           about_z = from_axis_angle(Vec3::UnitZ(), 90 * degree);

std::string three_numbers(const Vec3& v) {
  std::string text;
  for (const double x : v) text += (text.empty() ? "" : ", ") + support::svg_number(x, 4);
  return "(" + text + ")";
}

}  // namespace

Table product_by_hand_table() {
  Table table({"part", "number"});
  const Quat &a = about_z, &b = about_x;
  table.add({"s t − a · b", number(a.w() * b.w() - a.vec().dot(b.vec()))});
  table.add({"s b", three_numbers(a.w() * b.vec())});
  table.add({"t a", three_numbers(b.w() * a.vec())});
  table.add({"a × b", three_numbers(a.vec().cross(b.vec()))});
  table.add({"the product", four_numbers(a * b)});
  return table;
}

Table point_by_hand_table() {
  Table table({"point", "turned by (½, ½, ½, ½)"});
  const Mat3 R = to_matrix(about_z * about_x);
  for (const Vec3& p : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 1, 1)})
    table.add({three_numbers(p), three_numbers(R * p)});
  return table;
}

Table halfway_table() {
  Table table({"halfway from 1 to", "volume of nine mixed numbers", "length of four"});
  for (const double turn : {90., 150., 178., 180.}) {
    const Quat goal = from_axis_angle(Vec3::UnitZ(), turn * degree);
    const Mat3 nine = (Mat3::Identity() + to_matrix(goal)) / 2;
    table.add({number(turn) + "° about z", support::svg_number(nine.determinant(), 4),
               number(mix_four(Quat::Identity(), goal, 0.5).norm(), 4)});
  }
  return table;
}

Table shrink_table() {
  Table table({"RK4, 2 rad/s, 60 steps per second", "number"});
  const double turn = 2 * h, per_step = std::pow(turn, 6) / 9216;
  const double steps = std::log(1 / 0.99) / per_step, years = steps * h / (86400 * 365.25);
  table.add({"a step turns by", number(turn) + " rad"});
  table.add({"a step shortens q by", number(per_step, 2)});
  table.add({"1 % shorter after", number(years, 2) + " years"});
  return table;
}

}  // namespace quaternions_chapter
