#include <algorithm>
#include <cmath>
#include <limits>

#include "contract.hpp"

namespace when_bodies_meet {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Per unit of normal impulse: against the slip. Without slip, what holds it there, or as much of
/// that as μ allows.
double friction(const Eigen::Matrix2d& K, double slip, double mu) {
  if (slip != 0) return -std::copysign(mu, slip);
  // K_tt f + K_nt = 0
  return std::clamp(-K(0, 1) / K(0, 0), -mu, mu);
}

/// A contact while the normal impulse grows. Between two changes of friction u(p) is straight.
struct Contact {
  Eigen::Vector2d u, j, press, rate;  // press = dj/dp, rate = du/dp

  void press_with(const Eigen::Matrix2d& K, double friction) {
    press = {friction, 1};
    rate = K * press;
  }
  double until_rest() const { return u[0] * rate[0] < 0 ? -u[0] / rate[0] : never; }
  double until_closest() const { return rate[1] > 0 ? -u[1] / rate[1] : never; }
  /// p u_n + ½ p² du_n/dp = work
  double until_given(double work) const {
    return (std::sqrt(u[1] * u[1] + 2 * rate[1] * work) - u[1]) / rate[1];
  }
  /// Goes on by p, and gives the work −∫ u_n dp that this takes.
  double go(double p) {
    const double work = -p * (u[1] + p * rate[1] / 2);
    j += p * press;
    u += p * rate;
    return work;
  }
};

}  // namespace

PlanarImpulse collide_with_friction(const Eigen::Matrix2d& K, const Eigen::Vector2d& u, double e,
                                    double mu) {
  Contact contact{u, Eigen::Vector2d::Zero(), {}, {}};
  if (u[1] >= 0) return {contact.j, false};
  contact.press_with(K, friction(K, u[0], mu));
  const bool jammed = contact.rate[1] <= 0;
  const auto come_to_rest = [&] {
    const double work = contact.go(contact.until_rest());
    contact.u[0] = 0;
    contact.press_with(K, friction(K, 0, mu));
    return work;
  };

  // They come together until u_n = 0, which takes the work W …
  double work = 0;
  if (contact.until_rest() < contact.until_closest()) work += come_to_rest();
  work += contact.go(contact.until_closest());
  // … and part until e² W is given back.
  work *= e * e;
  if (contact.until_rest() < contact.until_given(work)) work += come_to_rest();
  contact.go(contact.until_given(work));
  return {contact.j, jammed};
}

}  // namespace when_bodies_meet
