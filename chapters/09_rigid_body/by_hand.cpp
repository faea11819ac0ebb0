/// @file
/// One step of Euler's method with numbers that fit on paper, and what happens to a quaternion of
/// another length.

#include "common.hpp"
#include "parts.hpp"

namespace rigid_body_chapter {

namespace {

/// Its weight, and a cord that pulls along y at the point (1, 0, 0) of the body.
Wrench<> weight_and_cord(double, const RigidBody<>& body, const Derived<>& now) {
  const Vec3 weight = body.mass() * Vec3(0, 0, -10);  // g rounded, for paper
  const Vec3 pull(0, 5, 0);
  const Vec3 arm = now.R * Vec3(1, 0, 0);  // from the centre of mass to the knot
  return {weight + pull, arm.cross(pull)};
}

const RigidBody<>& paper_body() {
  static const RigidBody<> body(2, Vec3(2, 4, 5).asDiagonal());
  return body;
}

RigidBodyState<> paper_state() {
  return {{0, 0, 1}, Quat(0.8, 0, 0, 0.6), {4, 0, 6}, {-3.28, 3.04, 5}};
}

PackedState<double> paper_rate(const RigidBodyState<>& state) {
  const auto wrench = [](double t, const RigidBody<>& body, const Derived<>& now) {
    return weight_and_cord(t, body, now);
  };
  return RigidBodyRhs(paper_body(), wrench)(0, pack(state));
}

std::string short_number(double value) { return support::svg_number(value, 4); }

std::string in_brackets(const Vec3& v) {
  return "(" + short_number(v.x()) + ", " + short_number(v.y()) + ", " + short_number(v.z()) + ")";
}

}  // namespace

Table derived_by_hand_table() {
  Table table({"what", "number"});
  const Derived<> now = derived(paper_body(), paper_state());
  const Vec3 L_body = now.R.transpose() * paper_state().L;
  const Wrench<> push = weight_and_cord(0, paper_body(), now);
  table.add({"v = P/m", in_brackets(now.v)});
  table.add({"L_body = Rᵀ L", in_brackets(L_body)});
  table.add({"ω_body = I_body⁻¹ L_body", in_brackets(now.R.transpose() * now.omega)});
  table.add({"ω = R ω_body", in_brackets(now.omega)});
  table.add({"F", in_brackets(push.force)});
  table.add({"τ", in_brackets(push.torque)});
  return table;
}

Table step_by_hand_table() {
  Table table({"place", "number", "y", "its rate", "y + 0.1 × rate"});
  const std::array<const char*, 13> names{"x_x", "x_y", "x_z", "q_w", "q_x", "q_y", "q_z",
                                          "P_x", "P_y", "P_z", "L_x", "L_y", "L_z"};
  const PackedState<double> y = pack(paper_state()), rate = paper_rate(paper_state());
  const PackedState<double> next = runge_kutta::euler_step(
      [](double, const PackedState<double>& at) { return paper_rate(unpack<double>(at)); }, 0.0, y,
      0.1);
  for (Eigen::Index i = 0; i < 13; ++i)
    table.add({std::to_string(i), names[static_cast<std::size_t>(i)], short_number(y[i]),
               short_number(rate[i]), short_number(next[i])});
  return table;
}

Table length_by_hand_table() {
  Table table({"what", "number"});
  const PackedState<double> rate = paper_rate(paper_state());
  const Eigen::Vector4d q = pack(paper_state()).segment<4>(3), next = q + 0.1 * rate.segment<4>(3);
  table.add({"|q| after the step", short_number(next.norm())});
  RigidBodyState<> doubled = paper_state();
  doubled.q.coeffs() *= 2;
  const Eigen::Vector4d twice = paper_rate(doubled).segment<4>(3);
  table.add({"rate of q, from 2q", "(" + short_number(twice[0]) + ", " + short_number(twice[1]) +
                                       ", " + short_number(twice[2]) + ", " +
                                       short_number(twice[3]) + ")"});
  return table;
}

Table term_by_hand_table() {
  Table table({"what", "number"});
  const Derived<> now = derived(paper_body(), paper_state());
  const Vec3 omega = now.R.transpose() * now.omega, L = now.R.transpose() * paper_state().L;
  const Vec3 term = -omega.cross(L);
  table.add({"−ω_body × L_body", in_brackets(term)});
  table.add({"its power", short_number(std::abs(omega.dot(term)) < 1e-12 ? 0 : omega.dot(term))});
  return table;
}

}  // namespace rigid_body_chapter
