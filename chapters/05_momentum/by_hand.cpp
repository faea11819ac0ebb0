/// @file
/// Numbers that fit on paper: a lever, a kick, two masses on a rod.

#include "common.hpp"
#include "parts.hpp"
#include "plank.hpp"
#include "tumble/mass/points.hpp"

namespace momentum_chapter {

namespace {

std::string in_brackets(const Vec3& v) {
  const auto text = [](double value) { return support::svg_number(value, 3); };
  return "(" + text(v.x()) + ", " + text(v.y()) + ", " + text(v.z()) + ")";
}

/// Two masses of 1 kg on a light rod that leans by 45°.
Mat3 leaning_rod() {
  const Vec3 r(1, 0, 1);
  const std::array<PointMass, 2> masses{PointMass{1, r}, {1, -r}};
  return mass_properties(masses).inertia;
}

}  // namespace

Table lever_table() {
  Table table({"the force acts at", "arm", "torque"});
  const Vec3 force(3, 4, 0), x(1, 1, 0);
  for (const Vec3& p : {Vec3(3, 1, 0), Vec3(6, 5, 0)})
    table.add({in_brackets(p) + " m", in_brackets(p - x) + " m",
               in_brackets(force_at_point<double>(force, p, x).torque) + " N m"});
  return table;
}

Table sixth_table() {
  Table table({"point of the plank", "from its centre", "velocity after the kick"});
  const double kick = 2, out = plank_length / 6;  // [N s], [m]
  RigidBodyState<> state;
  state.P = Vec3(0, kick, 0);
  state.L = Vec3(out, 0, 0).cross(state.P);
  const Derived<> now = derived(plank(), state);
  const auto add = [&](const std::string& name, double along) {
    const Vec3 velocity = point_velocity<double>(now, Vec3(along, 0, 0));
    table.add({name, number(along, 2) + " m", number(velocity.y(), 2) + " m/s"});
  };
  add("where you kick", out);
  add("its centre of mass", 0);
  add("the far end", -plank_length / 2);
  return table;
}

Table askew_table() {
  Table table({"what", "x", "y", "z"});
  const Mat3 I = leaning_rod();
  const Vec3 omega(0, 0, 1), L = I * omega;
  const auto add = [&table](const std::string& name, const Vec3& v) {
    const auto text = [](double value) { return support::svg_number(value, 3); };
    table.add({name, text(v.x()), text(v.y()), text(v.z())});
  };
  add("I, first row [kg m²]", I.row(0));
  add("I, second row", I.row(1));
  add("I, third row", I.row(2));
  add("L = I ω [kg m²/s]", L);
  add("ω × L [N m]", omega.cross(L));
  return table;
}

Table along_table() {
  Table table({"ω [rad/s]", "L [kg m²/s]"});
  for (const Vec3& omega : {Vec3(1, 0, -1), Vec3(1, 0, 1)})
    table.add({in_brackets(omega), in_brackets(leaning_rod() * omega)});
  return table;
}

}  // namespace momentum_chapter
