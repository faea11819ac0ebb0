#pragma once
/// @file
/// Three laws for a contact with friction in a plane: Newton's with the slip of the start,
/// Poisson's, and Stronge's.

#include <algorithm>
#include <limits>
#include <vector>

#include "11_when_bodies_meet/planar_impact.hpp"
#include "tumble/contact/friction_impulse.hpp"

namespace contact_chapter {

/// The velocity while the normal impulse p grows: straight pieces, each with its own friction.
class ContactPath {
 public:
  explicit ContactPath(const PlanarImpact& impact) : K_(impact.K), mu_(impact.mu) {
    const Vec2 u = impact.u;
    begin(0, u, Vec2::Zero(), u.x() == 0 ? at_rest() : -std::copysign(mu_, u.x()));
    const double until_rest = -u.x() / pieces_[0].rate.x();
    if (u.x() == 0 || until_rest <= 0) return;
    Vec2 there = velocity(until_rest);
    there.x() = 0;
    begin(until_rest, there, impulse(until_rest), at_rest());
  }

  Vec2 velocity(double p) const { return at(p).u + (p - at(p).p) * at(p).rate; }
  Vec2 impulse(double p) const { return at(p).j + (p - at(p).p) * at(p).press; }

  /// The normal impulse at which the bodies no longer come together.
  double closest() const {
    const Piece& first = pieces_.front();
    const double p = first.p - first.u.y() / first.rate.y();
    if (pieces_.size() == 1 || (first.rate.y() > 0 && p <= pieces_[1].p)) return p;
    return pieces_[1].p - pieces_[1].u.y() / pieces_[1].rate.y();
  }

  /// What the normal impulse takes while it grows to p, less what it gives back: −∫ u_n dp.
  double taken(double p) const {
    const Piece& first = pieces_.front();
    const double end = std::min(p, rest());
    const double work = -end * (first.u.y() + end * first.rate.y() / 2);
    if (p <= end) return work;
    return work - (p - end) * (velocity(end).y() + velocity(p).y()) / 2;
  }

  /// Where the slip comes to an end; infinity if it doesn't.
  double rest() const {
    return pieces_.size() == 1 ? std::numeric_limits<double>::infinity() : pieces_[1].p;
  }

 private:
  struct Piece {
    double p;  ///< where it begins
    Vec2 u, j, press, rate;
  };

  void begin(double p, const Vec2& u, const Vec2& j, double friction) {
    const Vec2 press(friction, 1);
    pieces_.push_back({p, u, j, press, K_ * press});
  }
  double at_rest() const { return std::clamp(-K_(0, 1) / K_(0, 0), -mu_, mu_); }
  const Piece& at(double p) const {
    return pieces_.size() == 2 && p >= pieces_[1].p ? pieces_[1] : pieces_[0];
  }

  Mat2 K_;
  double mu_;
  std::vector<Piece> pieces_;
};

/// What most tutorials teach: u_n' = −e u_n; stick if the friction for it is within the cone, or
/// else friction μ against the slip with which the contact begins.
inline PlanarResult usual_law(const PlanarImpact& impact) {
  const Vec2 wanted(0, -impact.e * impact.u.y());
  const Vec2 stick = impact.K.inverse() * (wanted - impact.u);
  if (std::abs(stick.x()) <= impact.mu * stick.y()) return with_impulse(impact, stick);
  const Vec2 press(-std::copysign(impact.mu, impact.u.x()), 1);
  return with_impulse(impact, -(1 + impact.e) * impact.u.y() / impact.K.row(1).dot(press) * press);
}

/// The slip is followed; the normal impulse of parting is e times that of coming together.
inline PlanarResult poisson_law(const PlanarImpact& impact) {
  const ContactPath path(impact);
  return with_impulse(impact, path.impulse((1 + impact.e) * path.closest()));
}

/// A plane impact as one in space, where y is across the plane.
inline contact::Impact in_space(const PlanarImpact& impact) {
  Mat3 K = Mat3::Zero();
  K.diagonal() << impact.K(0, 0), impact.K(0, 0), impact.K(1, 1);
  K(0, 2) = K(2, 0) = impact.K(0, 1);
  return {K, {impact.u.x(), 0, impact.u.y()}, Vec3::UnitZ(), impact.e, impact.mu};
}

/// The law of the library: the slip is followed, and e² of the work comes back.
inline PlanarResult stronge_law(const PlanarImpact& impact) {
  const Vec3 j = contact::collide_with_friction(in_space(impact)).impulse;
  return with_impulse(impact, {j.x(), j.z()});
}

}  // namespace contact_chapter
