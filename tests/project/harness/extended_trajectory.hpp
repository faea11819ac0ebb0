#pragma once
/// @file
/// Where a scene's body goes, to the digits of a long double: the midpoint rule, extrapolated to
/// order 16, in principal axes that are found with double-doubles. Nothing of it is the library's.
///
/// Source: Hairer, Nørsett & Wanner, "Solving Ordinary Differential Equations I", 2nd ed. (1993),
/// II.9, for the extrapolation.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "project/harness/exact_axes.hpp"
#include "project/harness/motion_scene.hpp"

namespace tumble::test {

/// What is compared, in world coordinates.
struct LongState {
  LongVec x;
  Quaternion<Long> q;  ///< body → world
  LongVec P, L;
};

/// The exact motion of a scene, from its start on.
class ExtendedTrajectory {
 public:
  /// @param shift by how many units in their last places the start is moved: what that makes of the
  ///              end shows what the digits are worth
  explicit ExtendedTrajectory(const MotionScene& scene, int shift = 0) : scene_(scene) {
    const auto [R, moments] = exact_axes(scene.I_body);
    const auto quotient = [](const DD& a, const DD& b) { return as_long(a / b); };
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      J_[i] = as_long(moments[i]);
      per_J_[i] = quotient(1, moments[i]);
      euler_[i] = quotient(moments[j] - moments[k], moments[i]);
      for (int c = 0; c < 3; ++c) R_(c, i) = as_long(R(c, i));
    }
    const Vec3 L = scene.start.L;
    const Vector3<DD> L_body = into_body(scene.start.q, L);
    frame_ = quaternion_of(R_);
    const Quat& q = scene.start.q;
    const Quaternion<Long> long_q =
        Quaternion<Long>(q.w(), q.x(), q.y(), q.z()).normalized() * frame_;
    y_.head<3>() = scene.start.x.cast<Long>();
    y_.segment<4>(3) << long_q.w(), long_q.x(), long_q.y(), long_q.z();
    y_.segment<3>(7) = scene.start.P.cast<Long>();
    for (int i = 0; i < 3; ++i) {
      const DD along = R(0, i) * L_body[0] + R(1, i) * L_body[1] + R(2, i) * L_body[2];
      y_[10 + i] = quotient(along, moments[i]);
    }
    for (int i = 0; i < 13; ++i) y_[i] *= 1 + static_cast<Long>(shift * (i % 3 - 1)) * 0x1p-63L;
  }

  /// Goes on to a time [s from t0].
  /// @return false if that takes too long, or leaves the numbers
  bool advance_to(Long t) {
    while (t_ < t) {
      const Long h = std::min({h_, t - t_, longest_step()});
      if (!try_step(h)) return false;
    }
    return true;
  }

  LongState state() const {
    const Quaternion<Long> q = orientation(y_).normalized();
    const LongVec L_principal = J_.cwiseProduct(y_.tail<3>());
    return {y_.head<3>(), q * frame_.conjugate(), y_.segment<3>(7), q * L_principal};
  }

  /// Largest |x|, |P| and |L| so far.
  const LongVec& sizes() const { return sizes_; }

 private:
  using State = Eigen::Matrix<Long, 13, 1>;
  static constexpr int columns = 8;
  static constexpr Long tolerance = 1e-17L;

  static Quaternion<Long> quaternion_of(const Matrix3<Long>& R) {
    Matrix3<Long> proper = R;
    return Quaternion<Long>(proper).normalized();
  }

  static Quaternion<Long> orientation(const State& y) { return {y[3], y[4], y[5], y[6]}; }

  State rate(Long t, const State& y) {
    ++evaluations_;
    const Quaternion<Long> q = orientation(y);
    const Long n = q.squaredNorm();
    const LongVec x = y.head<3>(), v = y.segment<3>(7) / static_cast<Long>(scene_.mass),
                  w = y.tail<3>();
    const LongVec u = q.vec();
    const auto turn = [&](const LongVec& a, Long sign) -> LongVec {  // R a, or Rᵀ a
      const LongVec c = u.cross(a);
      return a + (2 * sign * q.w() / n) * c + (2 / n) * u.cross(c);
    };
    const SteadyForces& steady = scene_.steady;
    LongVec force = steady.force.cast<Long>() - static_cast<Long>(steady.linear_drag) * v;
    LongVec torque = -static_cast<Long>(steady.angular_drag) * w;  // in principal axes
    LongVec world = LongVec::Zero();
    for (const SteadyForces::AtPoint& f : steady.at_point) {
      const LongVec p = R_.transpose() * f.p_body.cast<Long>();
      torque += p.cross(turn(f.force.cast<Long>(), -1));
    }
    for (const SpringToWorld& spring : scene_.springs) {
      const LongVec p = R_.transpose() * spring.p_body.cast<Long>();
      const LongVec l = spring.anchor.cast<Long>() - x - turn(p, 1);
      const Long length = l.norm();
      if (length == 0) continue;
      const LongVec f = static_cast<Long>(spring.stiffness) *
                        (1 - static_cast<Long>(spring.rest_length) / length) * l;
      force += f;
      torque += p.cross(turn(f, -1));
    }
    for (const Pulse& pulse : scene_.pulses) {
      const Long s = (static_cast<Long>(scene_.t0) + t - static_cast<Long>(pulse.centre)) /
                     static_cast<Long>(pulse.width);
      const Long share = std::exp(-s * s);
      force += share * pulse.force.cast<Long>();
      world += share * pulse.torque.cast<Long>();
    }
    torque += turn(world, -1);
    State r;
    r.head<3>() = v;
    r[3] = -(u.dot(w)) / 2;
    r.segment<3>(4) = (q.w() * w + u.cross(w)) / 2;
    r.segment<3>(7) = force;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      r[10 + i] = euler_[i] * w[j] * w[k] + per_J_[i] * torque[i];
    }
    return r;
  }

  /// Within a pulse a step sees it; outside it ends where one begins.
  Long longest_step() const {
    Long longest = static_cast<Long>(scene_.t1) - static_cast<Long>(scene_.t0);
    for (const Pulse& pulse : scene_.pulses) {
      const Long from = static_cast<Long>(pulse.centre) - static_cast<Long>(scene_.t0) - t_;
      const Long reach = 7 * static_cast<Long>(pulse.width);
      if (from > reach)
        longest = std::min(longest, from - reach + reach / 100);
      else if (from > -reach)
        longest = std::min(longest, static_cast<Long>(pulse.width) / 2);
    }
    return longest;
  }

  State midpoint(const State& y, const State& rate0, Long h, int n) {
    const Long part = h / n;
    State before = y, now = y + part * rate0;
    for (int i = 1; i < n; ++i) {
      const State next = before + (2 * part) * rate(t_ + i * part, now);
      before = now;
      now = next;
    }
    return now;
  }

  bool try_step(Long h) {
    const State rate0 = rate(t_, y_);
    std::array<State, columns> T;
    State last;
    for (int j = 0; j < columns; ++j) {
      const int n = 2 * (j + 1);
      State value = midpoint(y_, rate0, h, n);
      for (int k = 0; k < j; ++k) {  // Aitken and Neville, in powers of h²
        const Long ratio = static_cast<Long>(n) / (2 * (j - k));
        const State improved =
            value + (value - T[static_cast<std::size_t>(k)]) / (ratio * ratio - 1);
        T[static_cast<std::size_t>(k)] = value;
        value = improved;
      }
      last = j > 0 ? T[static_cast<std::size_t>(j - 1)] : value;
      T[static_cast<std::size_t>(j)] = value;
    }
    const State end = T[columns - 1];
    if (!(end.array() == end.array()).all() || evaluations_ > 600'000) return false;
    const Long error = error_of(end - last, end) / tolerance;
    if (error <= 1 || h < 1e-12L * (t_ + h)) {
      t_ += h;
      y_ = end;
      grow_sizes(end);
    }
    const Long factor = error > 0 ? 0.8L * std::pow(error, -1.0L / (2 * columns - 1)) : 4;
    h_ = h * std::clamp(factor, 0.1L, 4.0L);
    return true;
  }

  void grow_sizes(const State& y) {
    const LongVec now(y.head<3>().norm(), y.segment<3>(7).norm(),
                      J_.cwiseProduct(y.tail<3>()).norm());
    sizes_ = sizes_.cwiseMax(now);
  }

  /// Of each group relative to what it is.
  static Long error_of(const State& e, const State& y) {
    const auto part = [](Long error, Long size) { return size > 0 ? error / size : error; };
    return std::max({part(e.head<3>().norm(), y.head<3>().norm() + 1e-6L * y.segment<3>(7).norm()),
                     e.segment<4>(3).norm(), part(e.segment<3>(7).norm(), y.segment<3>(7).norm()),
                     part(e.tail<3>().norm(), y.tail<3>().norm())});
  }

  const MotionScene scene_;
  LongVec J_, per_J_, euler_;
  Matrix3<Long> R_;
  Quaternion<Long> frame_;
  State y_;
  Long t_ = 0, h_ = 1e-3L;
  LongVec sizes_ = LongVec::Zero();
  long evaluations_ = 0;
};

}  // namespace tumble::test
