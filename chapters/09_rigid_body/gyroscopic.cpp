/// @file
/// The free handle by the right law in two forms, and by two wrong ones.

#include "common.hpp"
#include "laws.hpp"
#include "parts.hpp"

namespace rigid_body_chapter {

namespace {

/// The handle's state by a law after the time t.
RigidBodyState<> by_law(const Law& law, double t) {
  const RigidBodyState<> start = handle_start();
  const Vec3 omega = derived(handle(), start).omega;
  const Vec3 three = law.of_L ? start.L : to_matrix(start.q).transpose() * omega;
  const auto rate = [&law](double, const Seven& y) { return law.rate(handle(), y); };
  const Seven y = integrate_adaptive<Dop853>(rate, seven(start.q, three), 0.0, t, {1e-13, 1e-13}).y;
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
    table.add({std::string(law.name), std::to_string(flips_in(handle(), at, 30)),
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
