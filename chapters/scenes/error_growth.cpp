#include "scenes/error_growth.hpp"

#include <algorithm>
#include <cmath>

#include "tumble/contact/simulate_contacts.hpp"
#include "tumble/quaternion/exp_log.hpp"

namespace tumble::scenes {
namespace {

constexpr double start_difference = 1e-9;

/// One of the eight diagonals of space, so that bodies that meet are not disturbed alike.
Vec3 diagonal(std::size_t i) {
  return Vec3(i & 1 ? -1 : 1, i & 2 ? -1 : 1, i & 4 ? -1 : 1).normalized();
}

/// A body whose centre moves a billionth differently, and which turns a billionth differently.
contact::ContactBody disturbed(contact::ContactBody body, const Vec3& gravity,
                               const Vec3& direction) {
  const Derived<> now = derived(body.body, body.start);
  const double reach = body.shape.reach();
  const double speed = now.v.norm() + reach * now.omega.norm() + std::sqrt(gravity.norm() * reach);
  const Vec3 by = start_difference * speed * direction;
  body.start = state_of_motion<double>(body.body, body.start.x, body.start.q, now.v + by,
                                       now.omega + by / reach);
  return body;
}

/// Two runs, up to the end of the shorter one.
class Pair {
 public:
  explicit Pair(const Contacts& contacts) : first_(contacts), scene_(contacts.scene) {
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i)
      scene_.bodies[i] = disturbed(scene_.bodies[i], scene_.gravity, diagonal(i));
    second_ = simulate_contacts(scene_, contacts.settings);
  }

  int bodies() const { return static_cast<int>(scene_.bodies.size()); }
  double end() const { return std::min(first_.run.t, second_.t); }
  double reach(int body) const { return scene_.body(body).shape.reach(); }

  double distance(int body, double t) const {
    return (first_.run.state(first_.scene, body, t).x - second_.state(scene_, body, t).x).norm();
  }
  double angle(int body, double t) const {
    return angle_between(first_.run.state(first_.scene, body, t).q,
                         second_.state(scene_, body, t).q);
  }

  /// How far points of the body are apart [m].
  double apart(int body, double t) const {
    return distance(body, t) + reach(body) * angle(body, t);
  }

  const std::vector<contact::ImpactEvent>& impacts() const { return first_.run.impacts; }

 private:
  const Contacts& first_;
  contact::ContactScene scene_;
  contact::ContactRun second_;
};

/// When a body bounces [s]. The hops of a contact that lasts are far weaker than its first impacts.
std::vector<double> bounces_of(const Pair& runs, int body) {
  constexpr double faint = 0.01;
  std::vector<double> times;
  double strongest = 0;
  for (const contact::ImpactEvent& impact : runs.impacts()) {
    if (impact.body != body && impact.other != body) continue;
    const double strength = impact.impulse.norm();
    strongest = std::max(strongest, strength);
    if (impact.t > runs.end()) break;
    if (strength >= faint * strongest && (times.empty() || impact.t > times.back()))
      times.push_back(impact.t);
  }
  return times;
}

/// The factor of the line that fits the logarithms of the errors best, one error for each bounce,
/// as long as the errors are small.
std::optional<double> factor_per_bounce(const Pair& runs, int body,
                                        const std::vector<double>& times) {
  constexpr std::size_t fewest = 3;
  constexpr double small = 0.1;
  std::vector<double> logarithms;
  for (const double t : times) {
    const double apart = runs.apart(body, t);
    if (!(apart > 0) || apart > small * runs.reach(body)) break;
    logarithms.push_back(std::log(apart));
  }
  if (logarithms.size() < fewest) return {};
  const double middle = static_cast<double>(logarithms.size() - 1) / 2;
  double products = 0, squares = 0;
  for (std::size_t k = 0; k < logarithms.size(); ++k) {
    const double from_middle = static_cast<double>(k) - middle;
    products += from_middle * logarithms[k];
    squares += from_middle * from_middle;
  }
  return std::exp(products / squares);
}

/// The first time, between impacts as well, at which the runs are as far apart as the body reaches.
std::optional<double> lost_at(const Pair& runs, int body) {
  constexpr int halvings = 50;
  double before = 0;
  const auto lost = [&](double t) { return runs.apart(body, t) > runs.reach(body); };
  std::vector<double> times;
  for (const contact::ImpactEvent& impact : runs.impacts())
    if (impact.t < runs.end()) times.push_back(impact.t);
  times.push_back(runs.end());
  for (double after : times) {
    if (!lost(after)) {
      before = after;
      continue;
    }
    for (int i = 0; i < halvings; ++i) {
      const double middle = (before + after) / 2;
      (lost(middle) ? after : before) = middle;
    }
    return after;
  }
  return {};
}

}  // namespace

ErrorGrowth error_growth(const Contacts& contacts) {
  const Pair runs(contacts);
  ErrorGrowth growth{start_difference, 0, 0, {}};
  for (int body = 0; body < runs.bodies(); ++body) {
    growth.distance = std::max(growth.distance, runs.distance(body, runs.end()));
    growth.angle = std::max(growth.angle, runs.angle(body, runs.end()));
    const std::vector<double> times = bounces_of(runs, body);
    growth.bodies.push_back({static_cast<int>(times.size()), factor_per_bounce(runs, body, times),
                             lost_at(runs, body)});
  }
  return growth;
}

}  // namespace tumble::scenes
