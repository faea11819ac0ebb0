/// @file
/// The free handle by the right law in two forms, and by two wrong ones.

#include "common.hpp"
#include "parts.hpp"

namespace rigid_body_chapter {

namespace {

/// q, and L or ω in body axes.
using Seven = Eigen::Matrix<double, 7, 1>;

Quat orientation_in(const Seven& y) { return {y[0], y[1], y[2], y[3]}; }

Seven seven(const Quat& q, const Vec3& three) {
  Seven y;
  y << coefficients(q), three;
  return y;
}

/// A law of motion for a body that nothing pushes, and what its last three numbers are.
struct Law {
  std::string name;
  Seven (*rate)(double, const Seven&);
  bool of_L;  ///< L in world axes; else ω in body axes
};

Vec3 omega_of(const Quat& q, const Vec3& L) { return angular_velocity(handle(), to_matrix(q), L); }

Seven L_stays(double, const Seven& y) {
  const Quat q = orientation_in(y);
  return seven(rotation::quaternion_dot<double>(q, omega_of(q, y.tail<3>())), Vec3::Zero());
}

Seven by_euler(double, const Seven& y) {
  const Vec3 omega = y.tail<3>(), L = handle().I_body() * omega;
  return seven(rotation::quaternion_dot_body<double>(orientation_in(y), omega),
               handle().I_body_inv() * L.cross(omega));
}

Seven omega_stays(double, const Seven& y) {
  return seven(rotation::quaternion_dot_body<double>(orientation_in(y), y.tail<3>()), Vec3::Zero());
}

Seven with_the_term_in_the_world(double, const Seven& y) {
  const Quat q = orientation_in(y);
  const Vec3 L = y.tail<3>(), omega = omega_of(q, L);
  return seven(rotation::quaternion_dot<double>(q, omega), L.cross(omega));
}

const std::array<Law, 4> laws{Law{"rate of L: 0", L_stays, true},
                              {"rate of ω: I⁻¹ (−ω × I ω)", by_euler, false},
                              {"rate of ω: 0, term left out", omega_stays, false},
                              {"rate of L: −ω × L, term put in", with_the_term_in_the_world, true}};

/// The handle's state by a law after the time t.
RigidBodyState<> by_law(const Law& law, double t) {
  const RigidBodyState<> start = handle_start();
  const Vec3 omega = derived(handle(), start).omega;
  const Vec3 three = law.of_L ? start.L : to_matrix(start.q).transpose() * omega;
  const Seven y =
      integrate_adaptive<Dop853>(law.rate, seven(start.q, three), 0.0, t, {1e-13, 1e-13}).y;
  const Quat q = orientation_in(y);
  const Vec3 last = y.tail<3>();
  const Vec3 L = law.of_L ? last : to_matrix(q) * (handle().I_body() * last);
  return {Vec3::Zero(), q, Vec3::Zero(), L};
}

/// Where ω about the middle axis passes zero, in a motion that is looked at every tenth of a
/// second.
template <class At>
int flips_in(const RigidBody<>& body, const At& at, double duration) {
  int flips = 0;
  double before = omega_principal(body, at(0))[1];
  for (int i = 1; i <= static_cast<int>(10 * duration); ++i) {
    const double now = omega_principal(body, at(0.1 * i))[1];
    flips += before * now < 0;
    before = now;
  }
  return flips;
}

/// The angle between two directions [rad].
double angle_apart(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

}  // namespace

Table laws_table() {
  Table table({"law", "flips in 30 s", "off after 10 s", "energy", "|L|", "L turned by"});
  const RigidBodyState<> start = handle_start(), exact = FreeTrajectory(handle(), start).at(10);
  const auto kept = [](double change) {
    return std::abs(change) < 1e-8 ? std::string("kept") : error_number(change);
  };
  for (const Law& law : laws) {
    const auto at = [&](double t) { return by_law(law, t); };
    const RigidBodyState<> end = at(10);
    const double off = turned_apart(end, exact);
    double turned = 0;
    for (int i = 1; i <= 100; ++i) turned = std::max(turned, angle_apart(start.L, at(0.1 * i).L));
    table.add({law.name, std::to_string(flips_in(handle(), at, 30)),
               off < 1e-7 ? "< 1e-7 rad" : number(off) + " rad",
               kept(kinetic_energy(handle(), end) / kinetic_energy(handle(), start) - 1),
               kept(end.L.norm() / start.L.norm() - 1),
               turned < 1e-8 ? "0" : number(turned, 2) + " rad"});
  }
  return table;
}

std::string laws_figure() {
  support::Plot plot{"ω about the middle axis of a free handle", {"time [s]"}, {"[rad/s]"}, {}};
  const std::array<std::string, 3> names{"right law", "term left out", "term put in"};
  const std::array<std::size_t, 3> which{0, 2, 3};
  for (std::size_t i = 0; i < 3; ++i) {
    support::Series series{names[i], {}, {}};
    for (int k = 0; k <= 200; ++k) {
      const double t = 0.05 * k;
      series.x.push_back(t);
      series.y.push_back(omega_principal(handle(), by_law(laws[which[i]], t))[1]);
    }
    plot.series.push_back(series);
  }
  return support::to_svg(plot);
}

}  // namespace rigid_body_chapter
