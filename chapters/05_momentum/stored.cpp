/// @file
/// A free body, integrated with L in the state or with ω in it; and where ω goes meanwhile.

#include <cmath>

#include "common.hpp"
#include "parts.hpp"
#include "support/counted.hpp"
#include "support/plot.hpp"
#include "support/stopwatch.hpp"
#include "thrown_objects.hpp"

namespace momentum_chapter {

namespace {

/// q and three more numbers: L, or ω in world axes, or ω in body axes.
template <class T>
using Seven = Eigen::Matrix<T, 7, 1>;

template <class T>
Quaternion<T> orientation_of(const Seven<T>& y) {
  return {y[0], y[1], y[2], y[3]};
}

template <class T>
Seven<T> seven(const Quaternion<T>& q, const Vector3<T>& three) {
  Seven<T> y;
  y << coefficients(q), three;
  return y;
}

template <class T>
const RigidBody<T>& subject() {
  static const RigidBody<T> body(properties_of(free_handle));
  return body;
}

/// L̇ = 0.
template <class T>
Seven<T> rate_of_L(T, const Seven<T>& y) {
  const Quaternion<T> q = orientation_of(y);
  const Vector3<T> L = y.template tail<3>();
  const Vector3<T> omega = angular_velocity(subject<T>(), to_matrix(q), L);
  return seven<T>(rotation::quaternion_dot(q, omega), Vector3<T>::Zero());
}

/// ω̇ = −I⁻¹ (ω × L).
template <class T>
Seven<T> rate_of_omega(T, const Seven<T>& y) {
  const Quaternion<T> q = orientation_of(y);
  const Matrix3<T> R = to_matrix(q);
  const Vector3<T> omega = y.template tail<3>();
  const Vector3<T> turning = angular_momentum(subject<T>(), R, omega).cross(omega);
  return seven<T>(rotation::quaternion_dot(q, omega), angular_velocity(subject<T>(), R, turning));
}

/// The same in body axes, where the tensor stands still.
template <class T>
Seven<T> rate_of_omega_body(T, const Seven<T>& y) {
  const Vector3<T> omega = y.template tail<3>();
  const Vector3<T> L_body = subject<T>().I_body() * omega;
  const Vector3<T> turning = L_body.cross(omega);
  return seven<T>(rotation::quaternion_dot_body(orientation_of(y), omega),
                  subject<T>().I_body_inv() * turning);
}

/// As if ω stayed, because nothing pushes.
template <class T>
Seven<T> rate_of_constant_omega(T, const Seven<T>& y) {
  const Vector3<T> omega = y.template tail<3>();
  return seven<T>(rotation::quaternion_dot(orientation_of(y), omega), Vector3<T>::Zero());
}

using Counted = support::Counted;

/// Three numbers that tell, together with the orientation, how a body spins.
struct Storage {
  std::string name, law;
  Seven<double> (*rate)(double, const Seven<double>&);
  Seven<Counted> (*counted)(Counted, const Seven<Counted>&);
  Vec3 (*from_omega)(const Mat3& R, const Vec3& omega);
  Vec3 (*to_omega)(const Mat3& R, const Vec3& stored);
};

Vec3 same(const Mat3&, const Vec3& omega) { return omega; }

const std::array<Storage, 4> storages{
    Storage{"L", "0", rate_of_L<double>, rate_of_L<Counted>,
            [](const Mat3& R, const Vec3& omega) {
              return angular_momentum(subject<double>(), R, omega);
            },
            [](const Mat3& R, const Vec3& L) { return angular_velocity(subject<double>(), R, L); }},
    {"ω", "−I⁻¹ (ω × I ω)", rate_of_omega<double>, rate_of_omega<Counted>, same, same},
    {"ω_body", "−I⁻¹ (ω × I ω)", rate_of_omega_body<double>, rate_of_omega_body<Counted>,
     [](const Mat3& R, const Vec3& omega) -> Vec3 { return R.transpose() * omega; },
     [](const Mat3& R, const Vec3& omega_body) -> Vec3 { return R * omega_body; }},
    {"ω", "0: wrong", rate_of_constant_omega<double>, rate_of_constant_omega<Counted>, same, same}};

// ── The free handle ──

constexpr double spin_time = 10;     // [s]
const Vec3 spin_start(6, 0.3, 0.3);  // in body axes, mostly about the stem [rad/s]

struct Spinning {
  Quat q;
  Vec3 omega;
};

template <class Method>
Spinning spun(const Storage& storage, double seconds, int steps) {
  const Vec3 start = storage.from_omega(Mat3::Identity(), spin_start);
  const Seven<double> y = integrate_fixed<Method>(
      storage.rate, seven<double>(Quat::Identity(), start), 0, seconds, steps);
  const Quat q = orientation_of(y);
  return {q, storage.to_omega(to_matrix(q), y.tail<3>())};
}

Vec3 L_of(const Spinning& s) {
  return angular_momentum<double>(subject<double>(), to_matrix(s.q), s.omega);
}

double energy_of(const Spinning& s) { return L_of(s).dot(s.omega) / 2; }

/// The orientation in the end, to 12 digits.
const Quat& exact_end() {
  static const Quat q = [] {
    const Vec3 L = storages[0].from_omega(Mat3::Identity(), spin_start);
    const Seven<double> y =
        integrate_adaptive<Dop853>(rate_of_L<double>, seven<double>(Quat::Identity(), L), 0,
                                   spin_time, {1e-14, 1e-16})
            .y;
    return orientation_of(y);
  }();
  return q;
}

/// How far what a free body keeps is off in the end, or that nothing finite is left of it.
template <class Method>
void add_kept(Table& table, const std::string& method, double rate, double seconds) {
  const Spinning start{Quat::Identity(), spin_start};
  for (std::size_t i = 0; i < 3; ++i) {
    const Spinning end = spun<Method>(storages[i], seconds, static_cast<int>(rate * seconds));
    const double L_off = (L_of(end) - L_of(start)).norm() / L_of(start).norm();
    const double energy_off = std::abs(energy_of(end) / energy_of(start) - 1);
    const bool finite = L_off < 1e6;
    table.add({method, number(rate), storages[i].name,
               finite ? error_or_rounding(L_off) : "blows up",
               finite ? error_or_rounding(energy_off) : "blows up"});
  }
}

template <class Method>
void add_work(support::Plot& plot, const std::string& method, int stages) {
  for (std::size_t i = 0; i < 3; ++i) {
    support::Series series{method + ", " + storages[i].name, {}, {}};
    series.colour = "c" + std::to_string(i);  // as L and ω have elsewhere
    for (int steps = 100; steps * stages <= 40000; steps = steps * 3 / 2) {
      const double off = angle_between(exact_end(), spun<Method>(storages[i], spin_time, steps).q);
      if (!(off < 1)) continue;
      series.x.push_back(steps * stages);
      series.y.push_back(off);
    }
    plot.series.push_back(series);
  }
}

}  // namespace

Table kept_table() {
  Table table({"method", "steps a second", "stored", "L off by", "energy off by"});
  constexpr double ten_minutes = 600;
  add_kept<runge_kutta::Euler>(table, "Euler", 60, ten_minutes);
  add_kept<runge_kutta::Midpoint>(table, "midpoint", 60, ten_minutes);
  add_kept<Rk4>(table, "RK4", 60, ten_minutes);
  add_kept<Rk4>(table, "RK4", 240, ten_minutes);
  return table;
}

Table stored_table() {
  Table table({"stored", "its rate", "one evaluation", "60 steps a second", "240", "960"});
  const Seven<Counted> y =
      seven<Counted>(Quaternion<Counted>(1, 0, 0, 0), spin_start.cast<Counted>());
  for (const Storage& storage : storages) {
    std::vector<std::string> row{
        storage.name, storage.law,
        support::text_of(support::count([&] { support::keep(storage.counted(0, y)); }))};
    for (const double rate : {60., 240., 960.}) {
      const Spinning end = spun<Rk4>(storage, spin_time, static_cast<int>(rate * spin_time));
      row.push_back(error_number(angle_between(exact_end(), end.q)) + " rad");
    }
    table.add(row);
  }
  return table;
}

std::string stored_figure() {
  support::Plot plot{"ten seconds of a free handle",
                     {"evaluations", support::Scale::log},
                     {"orientation off by [rad]", support::Scale::log},
                     {}};
  add_work<runge_kutta::Midpoint>(plot, "midpoint", 2);
  add_work<Rk4>(plot, "RK4", 4);
  return support::to_svg(plot);
}

// ── Where ω goes ──

namespace {

/// A body with three different moments, spinning askew.
const RigidBody<>& wanderer() {
  static const RigidBody<> body(1, Vec3(1, 1.6, 2.2).asDiagonal());
  return body;
}

std::vector<Moment> wandering(double duration, int count) {
  const RigidBodyState<> start = state_of_motion<double>(wanderer(), Vec3::Zero(), Quat::Identity(),
                                                         Vec3::Zero(), Vec3(0.3, 1, 0.55));
  return followed(RigidBodyRhs(wanderer()), start, duration, count);
}

}  // namespace

std::string wander_figure() {
  const std::vector<Moment> moments = wandering(92, 1200);
  const Vec3 L = angular_momentum(wanderer(), moments[0].now.R, moments[0].now.omega);
  const Vec3 up = L.normalized(), right = up.unitOrthogonal(), away = up.cross(right);
  const double tilt = 33 * degree;
  const auto seen = [&](const Vec3& p) {
    return Vec2(p.dot(right), std::cos(tilt) * p.dot(up) + std::sin(tilt) * p.dot(away));
  };
  support::Sketch sketch(640, 460, "The way of ω while L stands still");
  sketch.look({320, 440, 330});
  std::vector<Vec2> way;
  for (const Moment& m : moments) way.push_back(seen(m.now.omega));
  sketch.arrow({0, 0}, seen(1.22 * up), {"c0", 3});
  sketch.words(seen(1.22 * up), {10, 6}, "L", "c0");
  sketch.curve(way, {"c1", 1.2});
  sketch.arrow({0, 0}, way.back(), {"c1", 3});
  sketch.words(0.5 * way.back(), {way.back().x() > 0 ? 12. : -12., 12}, "ω", "c1",
               way.back().x() > 0 ? "start" : "end");
  return sketch.svg();
}

}  // namespace momentum_chapter
