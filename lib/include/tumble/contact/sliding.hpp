#pragma once
/// @file
/// How a contact with friction goes on from its first touch to its end: see friction_impulse.hpp
/// for the law.

#include <limits>
#include <optional>

#include "tumble/contact/friction_cone.hpp"
#include "tumble/contact/impact.hpp"
#include "tumble/ode/dop853.hpp"

namespace tumble::contact::detail {

/// One contact, in its own axes, from the first touch to the end.
class Contact {
 public:
  /// @param K, u of about 1: see collide_with_friction()
  Contact(const Mat3& K, const Vec3& u, double mu, double e) : K_(K), start_(u), mu_(mu), e_(e) {}

  void run() {
    constexpr int max_steps = 100'000;  // some hundred do, where the slip turns and dies away
    for (; !ended_; ++steps_) {
      if (steps_ == max_steps)
        tumble::detail::throw_error<std::runtime_error>("impact: it has no end");
      const Vec3 u = velocity();
      const Vec2 slip = u.head<2>();
      if (slip.norm() > rounding * speed_scale(K_, start_, j_))
        slide(u, slip.normalized());
      else
        leave_or_keep_rest(u);
    }
  }

  const Vec3& impulse() const { return j_; }
  Slip slip() const { return slip_; }
  bool jammed() const { return jammed_; }

 private:
  static constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
  static constexpr double never = std::numeric_limits<double>::infinity();

  Vec3 velocity() const { return start_ + K_ * j_; }

  // ── Straight parts: du/dp is constant ──

  void slide(const Vec3& u, const Vec2& direction) {
    if (slip_ == Slip::none) slip_ = Slip::kept;
    if (slip_ == Slip::stuck) slip_ = Slip::turned;
    const Vec3 press = pressing(-mu_ * direction), rate = K_ * press;
    if (j_.z() == 0 && rate.z() <= 0) jammed_ = true;
    const double along = direction.dot(rate.head<2>()), speed = u.head<2>().norm();
    const double turning = std::abs(direction.x() * rate.y() - direction.y() * rate.x());
    const double until_rest = along < 0 ? speed / -along : never;
    const double scale = speed_scale(K_, start_, j_);
    // What rounding leaves unsure of a slow slip's direction looks like turning, too.
    const double unsure = rounding * scale / speed * mu_ * K_.topLeftCorner<2, 2>().norm();
    constexpr double straight = 1e-13, settled_within = 1e-12;
    if (turning <= straight * rate.norm())
      go_straight(u, press, rate, until_rest);
    else if (speed <= slowest() * scale)  // at rest before a turn says anything
      leave_or_keep_rest(u);
    else if (const auto settled = settled_direction(direction, settled_within * scale / speed))
      follow(*settled, u);
    else if (turning <= unsure)
      go_straight(u, press, rate, along < 0 ? until_rest : speed / along);  // then it is surer
    else
      slide_in_a_curve();
  }

  /// The slip that counts as rest, as a part of the speeds that add up to it: all goes on as after
  /// a start with as much less slip, and collide_with_friction() takes away what energy this makes.
  /// One that has not settled after thousands of steps is led by rounding: it counts the sooner.
  double slowest() const { return 1e-10 * std::pow(std::fmax(1, steps_ / 1000.), 3); }

  /// The direction d in which a slip turns no more, K_tn − μ K_tt d = λ d, by Newton's method. It
  /// draws slips beside it towards itself, if they return to it: within a normal impulse of
  /// |slip|/returning. Steps of a slow slip's curve can be no longer than that, and rounding keeps
  /// them from ever arriving. So the slip follows d from when it is as near as steps can tell.
  /// @param most the angle to it [rad]
  std::optional<Vec2> settled_direction(const Vec2& from, double most) const {
    constexpr int max_rounds = 8;  // each doubles the digits
    Vec2 d = from;
    for (int i = 0; i < max_rounds; ++i) {
      const Vec2 across(-d.y(), d.x());
      const Vec2 rate = K_.topRows<2>() * pressing(-mu_ * d);
      const double returning = d.dot(rate) + mu_ * across.dot(K_.topLeftCorner<2, 2>() * across);
      const double turning = across.dot(rate);
      if (!(std::abs(turning) <= 2 * most * returning)) return {};
      d = (d + turning / returning * across).normalized();
    }
    if ((d - from).norm() <= most) return d;
    return {};
  }

  /// Along a direction that stays, to the end of this part, or of the slip.
  void follow(const Vec2& direction, const Vec3& u) {
    const Vec3 press = pressing(-mu_ * direction), rate = K_ * press;
    const double along = direction.dot(rate.head<2>());
    go_straight(u, press, rate, along < 0 ? direction.dot(u.head<2>()) / -along : never);
  }

  void leave_or_keep_rest(const Vec3& u) {
    const Vec2 holding = holding_friction(K_);
    const bool holds = holding.norm() <= mu_;
    slip_ = holds ? Slip::stuck : Slip::turned;
    const Vec3 press = pressing(holds ? holding : Vec2(-mu_ * direction_of_escape(K_, mu_)));
    go_straight(u, press, K_ * press, never);
  }

  /// On to the end of this part of the contact, or by the normal impulse `most`.
  void go_straight(const Vec3& u, const Vec3& press, const Vec3& rate, double most) {
    const double end = until_end(u.z(), rate.z());
    const double p = std::fmin(end, most);
    j_ += p * press;
    work_ += p * (u.z() + p * rate.z() / 2);
    if (end <= most) reached_end(u.z() + p * rate.z());
  }

  /// The normal impulse until the bodies no longer come together, or until the work e² W is done;
  /// or, if that never happens, until they come together again.
  double until_end(double u_n, double rate) const {
    if (coming_together_) return rate > 0 ? std::fmax(0, -u_n / rate) : never;
    const double missing = target_ - work_, square = u_n * u_n + 2 * rate * missing;
    return square >= 0 ? 2 * missing / (u_n + std::sqrt(square)) : -u_n / rate;
  }

  void reached_end(double u_n) {
    if (coming_together_) {
      coming_together_ = false;
      target_ = (1 - e_ * e_) * work_;
      ended_ = target_ == work_;  // e² is 0, or less than rounding
    } else {
      ended_ = work_ >= target_ * (1 + 1e-12) || u_n > 0;
      coming_together_ = !ended_;
    }
  }

  // ── Curves: the slip turns ──

  /// The impulse, and the work of its normal part.
  using Numbers = Eigen::Matrix<double, 4, 1>;

  Numbers rates(const Numbers& y) const {
    const Vec3 u = start_ + K_ * y.head<3>();
    const double speed = u.head<2>().norm();
    Numbers dydt;
    dydt << -mu_ * u.head<2>(), speed, u.z() * speed;
    return dydt;
  }

  /// Below 0 before the end of this part.
  double short_of_end(const Numbers& y) const {
    return coming_together_ ? (start_ + K_ * y.head<3>()).z() : y[3] - target_;
  }

  /// A step of the curve, to the end of this part at most.
  void slide_in_a_curve() {
    Numbers y;
    y << j_, work_;
    const auto f = [&](double, const Numbers& now) { return rates(now); };
    // K and the velocity at the start are about 1.
    constexpr Tolerances tolerances{.relative = 1e-13, .absolute = 1e-15};
    Dop853::Stepper<Numbers> stepper(tolerances, rates(y));
    auto attempt = stepper.attempt(f, 0., y, step_);
    for (; !attempt.accepted(); attempt = stepper.attempt(f, 0., y, step_)) step_ = attempt.next_h;
    Numbers next = attempt.y;
    const bool ends = short_of_end(next) >= 0;
    if (ends) next = at_end(f, y);
    step_ = attempt.next_h;
    j_ = next.head<3>();
    work_ = next[3];
    const double u_n = velocity().z();
    if (ends || (!coming_together_ && u_n < 0)) reached_end(u_n);
  }

  /// Where a step of the curve passes the end of this part.
  template <class Rates>
  Numbers at_end(const Rates& f, const Numbers& y) const {
    double low = 0, high = step_;
    while (std::nextafter(low, high) < high) {
      const double middle = low + (high - low) / 2;
      (short_of_end(Dop853::step(f, 0., y, middle)) < 0 ? low : high) = middle;
    }
    return Dop853::step(f, 0., y, high);
  }

  Mat3 K_;
  Vec3 start_;
  double mu_, e_;
  Vec3 j_ = Vec3::Zero();
  double work_ = 0, target_ = 0, step_ = 0.1;
  int steps_ = 0;
  bool coming_together_ = true, ended_ = false, jammed_ = false;
  Slip slip_ = Slip::none;
};

}  // namespace tumble::contact::detail
