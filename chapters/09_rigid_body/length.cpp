/// @file
/// The length of q: what becomes of it, and what it does.

#include "common.hpp"
#include "objects/hanging_mug.hpp"
#include "parts.hpp"

namespace rigid_body_chapter {

namespace {

PackedState<double> with_unit_q(PackedState<double> y) {
  y.segment<4>(3).normalize();
  return y;
}

double length_off(const PackedState<double>& y) { return std::abs(y.segment<4>(3).norm() - 1); }

/// When q is given the length 1.
enum class Repair { never, after_each_step, within_each_slope, both };

const std::array<std::pair<const char*, Repair>, 4> repairs{
    std::pair{"never", Repair::never},
    {"after each step", Repair::after_each_step},
    {"in each slope", Repair::within_each_slope},
    {"both", Repair::both}};

/// RK4's end state, and how far from 1 the length of q has been.
struct Drifted {
  PackedState<double> end;
  double worst;
};

template <class Rhs>
Drifted drifted(const Rhs& motion, const RigidBodyState<>& start, double duration, int steps,
                Repair repair) {
  const bool inside = repair == Repair::within_each_slope || repair == Repair::both;
  const bool after = repair == Repair::after_each_step || repair == Repair::both;
  const auto rate = [&](double t, const PackedState<double>& y) -> PackedState<double> {
    return inside ? motion(t, with_unit_q(y)) : motion(t, y);
  };
  const double h = duration / steps;
  Drifted result{pack(start), 0};
  for (int i = 0; i < steps; ++i) {
    result.end = runge_kutta::rk4_step(rate, i * h, result.end, h);
    result.worst = std::max(result.worst, length_off(result.end));
    if (after) result.end = with_unit_q(result.end);
  }
  return result;
}

}  // namespace

Table length_table() {
  Table table({"q normalised", "|q| − 1 at worst", "60 steps per second", "120", "240", "order"});
  constexpr int seconds = 10;
  const RigidBodyRhs motion(handle());
  const RigidBodyState<> exact = FreeTrajectory(handle(), handle_start()).at(seconds);
  for (const auto& [name, repair] : repairs) {
    const auto off = [&, how = repair](int rate) {
      const Drifted run = drifted(motion, handle_start(), seconds, rate * seconds, how);
      return turned_apart(unpack<double>(run.end), exact);
    };
    const Drifted coarse = drifted(motion, handle_start(), seconds, 60 * seconds, repair);
    table.add({name, error_number(coarse.worst), error_number(off(60)) + " rad",
               error_number(off(120)) + " rad", error_number(off(240)) + " rad",
               order_text(off(120), off(240))});
  }
  return table;
}

// ── A force that takes q at its word ──

namespace {

/// The mug's weight and a spring to a point of it that is turned with Eigen's q * p, which is right
/// for |q| = 1 only.
struct TrustingSpring {
  RigidBodyRhs<double, Weight> rest{mug(), weight};

  PackedState<double> operator()(double t, const PackedState<double>& y) const {
    const RigidBodyState<> state = unpack<double>(y);
    const Vec3 arm = state.q * spring.p_body, l = spring.anchor - (state.x + arm);
    const double tension = spring.stiffness * (l.norm() - spring.rest_length);
    const Vec3 F = tension * l.normalized();
    PackedState<double> rate = rest(t, y);
    rate.segment<3>(7) += F;
    rate.tail<3>() += arm.cross(F);
    return rate;
  }
};

/// ½ P·v + ½ L·ω, height and spring together [J]: without drag it stays.
double mug_energy(const RigidBodyState<>& state) {
  const Derived<> now = derived(mug(), state);
  const double stretch = point_position(now, spring.p_body).norm() - spring.rest_length;
  return kinetic_energy(mug(), state) - mug().mass() * weight.g.dot(now.x) +
         spring.stiffness / 2 * stretch * stretch;
}

}  // namespace

Table trusting_table() {
  Table table(
      {"after", "never: |q|", "energy gained", "after each step: |q| − 1", "energy gained"});
  constexpr int rate = 60;
  const double energy = mug_energy(mug_start());
  for (const int seconds : {5, 10, 20, 30, 40}) {
    const auto run = [&](Repair repair) {
      return drifted(TrustingSpring{}, mug_start(), seconds, rate * seconds, repair);
    };
    const auto gained = [&](const Drifted& drifted) {
      const double joule = mug_energy(unpack<double>(drifted.end)) - energy;
      return std::abs(joule) < 1e3 ? support::svg_number(joule, 3) + " J" : "blows up";
    };
    const Drifted never = run(Repair::never), after = run(Repair::after_each_step);
    table.add({std::to_string(seconds) + " s",
               never.worst < 100 ? support::svg_number(1 + never.worst, 4) : "blows up",
               gained(never), error_number(after.worst), gained(after)});
  }
  return table;
}

}  // namespace rigid_body_chapter
