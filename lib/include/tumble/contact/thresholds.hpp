#pragma once
/// @file
/// Which speeds and energies are low in a scene.

#include "tumble/contact/contact_run.hpp"
#include "tumble/contact/hops.hpp"
#include "tumble/contact/rest.hpp"

namespace tumble::contact::detail {

/// What counts as low in a run.
class Thresholds {
 public:
  Thresholds(const ContactScene& scene, const ContactSettings& settings)
      : scene_(scene), settings_(settings) {}

  /// How hard gravity pulls against the normal [m/s²].
  double pull(const Vec3& normal) const { return -normal.dot(scene_.gravity); }

  /// The speed of the lowest hops of a body.
  double lowest_hop(int i, const Vec3& normal) const {
    return hop_speed(std::max(0., pull(normal)), settings_.hop * scene_.body(i).shape.reach());
  }

  /// The speed after a fall through what counts as touching.
  /// @param touching [m]
  double fall(double touching) const { return hop_speed(scene_.gravity.norm(), touching); }

  /// What lies has energy for some hops, or, where bounces never die away, for as far as bodies
  /// touch. On a line of what is round nothing tips: its neighbours are nearly as low.
  Stillness stillness(int i, double touching, const Landings& landings) const {
    const double lift = scene_.e < 1 ? 10 * settings_.hop : touching / scene_.body(i).shape.reach();
    return {lift, std::max(1e-9 * landings.fastest, touching / settings_.until),
            landings.have_ended() ? 2e-3 : 1e-4};
  }

 private:
  const ContactScene& scene_;
  ContactSettings settings_;
};

}  // namespace tumble::contact::detail
