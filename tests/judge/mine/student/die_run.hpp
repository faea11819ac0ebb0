#pragma once
/// @file
/// A die on a table by a student's functions and by nothing else: the flight by 10.2, the gap by
/// 11.2, the time of a contact by 11.3, and what happens there by 11.4 and 11.5. It runs in the
/// student's process.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "10_only_what_a_scene_needs/contract.hpp"
#include "11_when_bodies_meet/contract.hpp"
#include "judge/mine/questions.hpp"

namespace tumble::judge::mine {

class DieOnTable {
 public:
  explicit DieOnTable(const DieQuestion& question)
      : question_(question),
        body_{question.mass, moment() * Eigen::Matrix3d::Identity(),
              Eigen::Matrix3d::Identity() / moment()},
        start_(rigid_body::unpack(question.start)) {}

  /// From impact to impact, until it takes too many distances.
  /// @throws std::runtime_error if it sinks into the table, or 11.3 answers with another time than
  ///         it was asked for
  DieAnswer run() {
    DieAnswer answer;
    while (static_cast<int>(answer.impacts.size()) < question_.max_impacts && comes_down()) {
      hit();
      answer.impacts.push_back({begin_, rigid_body::pack(start_)});
    }
    answer.queries = queries_;
    return answer;
  }

 private:
  double moment() const { return question_.mass * question_.edge * question_.edge / 6; }

  // ── A flight ──

  /// Where it is at a time. About all axes its moments are the same.
  rigid_body::State at(double t) const {
    const double since = t - begin_;
    const Eigen::Vector3d v = start_.P / body_.mass, g(0, 0, -question_.gravity);
    return {
        start_.x + since * (v + since / 2 * g),
        only_what_a_scene_needs::free_symmetric_top(moment(), moment(), start_.q, start_.L, since),
        start_.P + since * body_.mass * g, start_.L};
  }

  /// The speed with which its centre would land, if nothing else did before.
  double landing_speed() const {
    const double up = start_.P.z() / body_.mass;
    return std::sqrt(up * up + 2 * question_.gravity * start_.x.z());
  }

  /// The gap between table and die, and the normal out of the table. That the die's edges may be
  /// nearly parallel to the table's does no harm: the direction that counts is the table's own.
  when_bodies_meet::Separation separation_at(const rigid_body::State& state) const {
    constexpr double wide = 8, thick = 0.5;  // [m]
    const when_bodies_meet::Box table{
        {0, 0, -thick / 2}, Eigen::Matrix3d::Identity(), {wide, wide, thick}};
    return when_bodies_meet::separation(table, {state.x, rigid_body::derived(body_, state).R,
                                                Eigen::Vector3d::Constant(question_.edge)});
  }

  // ── From contact to contact ──

  /// Flies to the next contact at which a corner comes down.
  /// @return whether there is one
  bool comes_down() {
    const double up = start_.P.z() / body_.mass,
                 last = std::min(question_.duration,
                                 begin_ + (up + landing_speed()) / question_.gravity);
    for (double t = begin_; t < last && queries_ < most_queries;) {
      const when_bodies_meet::FirstContact contact = next_contact(t, last);
      if (!contact.found) {
        t = contact.t;
        continue;
      }
      if (touching_ = coming_down(at(contact.t)); !touching_.empty()) {
        start_ = at(contact.t);
        begin_ = contact.t;
        return true;
      }
      t = contact.t + question_.tolerance / speed_at(contact.t);  // it still leaves
    }
    return false;
  }

  /// Until when it gets no more than twice as fast, by 11.3.
  /// @return a contact, or when to go on looking
  when_bodies_meet::FirstContact next_contact(double t, double last) {
    const double now = speed_at(t), end = std::min(last, t + now / question_.gravity);
    const when_bodies_meet::FirstContact contact = when_bodies_meet::first_contact(
        [this](double time) { return gap_at(time); }, 2 * now, t, end, question_.tolerance);
    if (!contact.found) return {false, end};
    if (!(contact.t >= t && contact.t <= end))
      throw std::runtime_error("first_contact (11.3) was asked from " + std::to_string(t) + " to " +
                               std::to_string(end) + " s, and answers " +
                               std::to_string(contact.t) + " s");
    return contact;
  }

  /// With which none of its points goes up or down faster, and a little more [m/s].
  double speed_at(double t) const {
    constexpr double little = 0.01;
    const double up = start_.P.z() / body_.mass - question_.gravity * (t - begin_),
                 omega = rigid_body::derived(body_, start_).omega.norm();
    return std::abs(up) + omega * std::sqrt(0.75) * question_.edge + little;
  }

  double gap_at(double t) {
    constexpr double deep = 100;  // tolerances
    const double gap = separation_at(at(t)).gap;
    ++queries_;
    if (queries_ > 2 * most_queries)
      throw std::runtime_error("at " + std::to_string(t) + " s first_contact (11.3) has looked " +
                               std::to_string(queries_) + " times");
    if (gap < -deep * question_.tolerance)
      throw std::runtime_error("at " + std::to_string(t) + " s the die is inside the table");
    return gap;
  }

  /// The corners that touch and come down, seen from the centre.
  std::vector<Eigen::Vector3d> coming_down(const rigid_body::State& state) const {
    const rigid_body::Derived now = rigid_body::derived(body_, state);
    std::vector<Eigen::Vector3d> corners;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d side(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
      const Eigen::Vector3d arm = now.R * (question_.edge / 2 * side);
      const double height = state.x.z() + arm.z(), up = now.v.z() + now.omega.cross(arm).z();
      if (height <= 2 * question_.tolerance && up < 0) corners.push_back(arm);
    }
    return corners;
  }

  /// A slow corner gets back all its speed, but for what would be more than a hop.
  double restitution(double u_n) const {
    return std::max(question_.e, std::min(1., question_.hop / std::abs(u_n)));
  }

  /// Each corner that comes down gets its impulse.
  void hit() {
    const Eigen::Vector3d n = separation_at(start_).normal;
    for (const Eigen::Vector3d& arm : touching_) {
      const rigid_body::Derived now = rigid_body::derived(body_, start_);
      const Eigen::Matrix3d K = when_bodies_meet::contact_matrix(body_, start_, start_.x + arm);
      const Eigen::Vector3d u = now.v + now.omega.cross(arm);
      const Eigen::Vector3d impulse = when_bodies_meet::collide(K, u, n, restitution(u.dot(n)));
      start_.P += impulse;
      start_.L += arm.cross(impulse);
    }
  }

  static constexpr std::int64_t most_queries = 200'000;
  DieQuestion question_;
  rigid_body::Body body_;
  rigid_body::State start_;  ///< of this flight
  double begin_ = 0;         ///< of this flight [s]
  std::vector<Eigen::Vector3d> touching_;
  std::int64_t queries_ = 0;
};

}  // namespace tumble::judge::mine
