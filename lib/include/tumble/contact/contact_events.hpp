#pragma once
/// @file
/// Which impact comes next: all that the flights as they are may lead to, in a queue. What a body
/// may have met before it was pushed is passed over.
///
/// With many bodies only a window of time is looked at, in which a body gets about as far as its
/// size, so that few bounds overlap. Source: Lubachevsky, "How to simulate billiards and similar
/// systems", J. Computational Physics 94 (1991).

#include "tumble/collide/bounds_grid.hpp"
#include "tumble/contact/contact_run.hpp"
#include "tumble/contact/event_queue.hpp"

namespace tumble::contact::detail {

/// The flights of all bodies, and what they lead to.
class ContactEvents {
 public:
  ContactEvents(const ContactScene& scene, double tolerance)
      : scene_(scene), tolerance_(tolerance) {
    for (const ContactBody& b : scene.bodies) {
      flows_.emplace_back(b.body);
      axes_.push_back(principal_axes(b.body.I_body()));
      flights_.push_back({Flight(b.body, b.start, scene.gravity, 0), 0, -1, never});
    }
  }

  int size() const { return static_cast<int>(flights_.size()); }
  std::int64_t queries() const { return queries_; }
  RigidBodyState<> state(int i, double t) const { return of(i).flight.state(t); }
  bool is_ball(int i) const { return scene_.body(i).shape.points().size() == 1; }

  /// What counts as touching: no less than places have digits for.
  double tolerance(int i) const {
    return std::max(tolerance_, 16 * std::numeric_limits<double>::epsilon() *
                                    (scene_.body(i).start.x.norm() + scene_.body(i).shape.reach()));
  }

  /// How long to look ahead [s].
  double window() const {
    constexpr int few = 16;
    if (size() <= few) return std::numeric_limits<double>::infinity();
    double sizes = 0, speeds = 0;
    for (int i = 0; i < size(); ++i) {
      const double reach = scene_.body(i).shape.reach();
      sizes += reach;
      speeds += of(i).flight.at(begin_).v.norm() + std::sqrt(reach * scene_.gravity.norm());
    }
    return speeds > 0 ? 2 * sizes / speeds : std::numeric_limits<double>::infinity();
  }

  /// Finds what happens from `begin` to `end`, as long as all bodies fly as they do now.
  void begin_window(double begin, double end) {
    begin_ = begin;
    end_ = end;
    queue_.clear();
    std::vector<collide::Bounds> swept;
    swept.reserve(flights_.size());
    for (int i = 0; i < size(); ++i) swept.push_back(swept_by(i, begin));
    grid_ = collide::BoundsGrid(size(), mean_size(swept));
    for (int i = 0; i < size(); ++i) {
      grid_.put(i, swept[static_cast<std::size_t>(i)]);
      predict_own(i, begin);
      // Each pair once: of those after i nothing is known yet.
      predict_pairs(i, begin);
    }
  }

  /// Takes the next event, if there is one in this window.
  bool next() {
    while (!queue_.empty()) {
      Awaited first = queue_.pop();
      if (is_old(first.event)) continue;
      if (first.search.is_over) {
        event_ = std::move(first.event);
        return true;
      }
      go_on(std::move(first));
    }
    return false;
  }
  const ContactEvent& event() const { return event_; }

  /// A body flies on from a state.
  void fly(int i, const RigidBodyState<>& state, double t) {
    begin_flight(i, state, scene_.gravity, t, -1, never);
  }
  /// A body is carried by a floor: it rests or rolls, or it slides until it stops.
  void support(int i, const RigidBodyState<>& state, double t, int wall, const Vec3& acceleration,
               double stops) {
    begin_flight(i, state, acceleration, t, wall, stops);
  }
  bool all_rest() const { return std::all_of(flights_.begin(), flights_.end(), rests); }

 private:
  static constexpr double never = std::numeric_limits<double>::infinity();

  struct Leg {
    Flight flight;
    int number;    ///< how many began before it
    int on_wall;   ///< that carries it, or -1
    double stops;  ///< when it will have slid to its end [s]
  };
  static bool rests(const Leg& leg) { return leg.on_wall >= 0 && leg.flight.is_still(); }

  static double mean_size(const std::vector<collide::Bounds>& all) {
    double sum = 0;
    for (const collide::Bounds& bounds : all) sum += bounds.sizes().maxCoeff();
    return sum > 0 ? sum / static_cast<double>(all.size()) : 1;
  }

  Leg& of(int i) { return flights_[static_cast<std::size_t>(i)]; }
  const Leg& of(int i) const { return flights_[static_cast<std::size_t>(i)]; }
  collide::Moving<Flight> moving(int i) const { return {scene_.body(i).shape, of(i).flight}; }

  void begin_flight(int i, const RigidBodyState<>& state, const Vec3& gravity, double t,
                    int on_wall, double stops) {
    const auto k = static_cast<std::size_t>(i);
    of(i) = {Flight(scene_.body(i).body, flows_[k], axes_[k], state, gravity, t), of(i).number + 1,
             on_wall, stops};
    grid_.put(i, swept_by(i, t));
    queue_.tidy([this](const ContactEvent& event) { return is_old(event); });
    predict_own(i, t);
    predict_pairs(i, t);
  }

  /// Whether one of its bodies flies otherwise by now.
  bool is_old(const ContactEvent& event) const {
    return event.flight != of(event.body).number ||
           (event.other >= 0 && event.other_flight != of(event.other).number);
  }

  /// What happens to a body by itself.
  void predict_own(int i, double t) {
    predict_walls(i, t);
    if (of(i).stops <= end_)
      queue_.push({{i, -1, -1, of(i).number, 0, {true, of(i).stops}}, {0, true}});
  }

  /// What a body passes from t to the end of this window.
  collide::Bounds swept_by(int i, double t) const {
    return of(i).flight.swept(t, end_ - t, scene_.body(i).shape.reach() + tolerance(i));
  }

  void predict_walls(int i, double t) {
    if (rests(of(i))) return;
    for (int w = 0; w < static_cast<int>(scene_.walls.size()); ++w) {
      if (w == of(i).on_wall) continue;
      const collide::HalfSpace& wall = scene_.wall(w);
      const Vec3 half = grid_[i].sizes() / 2;
      const double above =
          wall.normal.dot(grid_[i].center() - wall.point) - wall.normal.cwiseAbs().dot(half);
      if (above <= 0) queue_.push({{i, -1, w, of(i).number, 0, {false, t}}, {}});
    }
  }

  void predict_pairs(int i, double t) {
    grid_.overlapping(i, [&](int j) { predict_pair(std::min(i, j), std::max(i, j), t); });
  }

  void predict_pair(int i, int j, double t) {
    if (rests(of(i)) && rests(of(j))) return;
    queue_.push({{i, j, -1, of(i).number, of(j).number, {false, t}}, {}});
  }

  /// Takes a search up again, until something else comes first.
  void go_on(Awaited awaited) {
    const ContactEvent& event = awaited.event;
    const collide::Moving<Flight> body = moving(event.body);
    if (event.other < 0)
      look(collide::detail::BodyAndWall(body, scene_.wall(event.wall)), tolerance(event.body),
           awaited);
    else
      look(collide::detail::TwoBodies(body, moving(event.other)),
           std::max(tolerance(event.body), tolerance(event.other)), awaited);
    if (!awaited.search.is_over || event.meeting.found) queue_.push(std::move(awaited));
  }

  template <class Things>
  void look(Things things, double tolerance, Awaited& awaited) {
    collide::Meeting& meeting = awaited.event.meeting;
    do {
      collide::detail::look_once(things, end_, tolerance, meeting, awaited.search);
      ++queries_;
    } while (!awaited.search.is_over && (queue_.empty() || meeting.t <= queue_.t()));
  }

  const ContactScene& scene_;
  double tolerance_, begin_ = 0, end_ = 0;
  std::vector<tumble::detail::FreeFlow> flows_;
  std::vector<PrincipalAxes> axes_;
  std::vector<Leg> flights_;
  collide::BoundsGrid grid_{0, 1};  ///< what each body passes in this window
  EventQueue queue_;
  ContactEvent event_{};
  std::int64_t queries_ = 0;
};

}  // namespace tumble::contact::detail
