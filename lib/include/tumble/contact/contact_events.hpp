#pragma once
/// @file
/// Which impact comes next: all that the flights as they are would lead to, in a queue. What a body
/// was predicted to meet before it was pushed is passed over.
///
/// With many bodies only a window of time is looked at, in which a body gets about as far as its
/// size, so that few bounds overlap. Source: Lubachevsky, "How to simulate billiards and similar
/// systems", J. Computational Physics 94 (1991).

#include <optional>
#include <queue>

#include "tumble/collide/bounds_grid.hpp"
#include "tumble/collide/first_meeting.hpp"
#include "tumble/contact/contact_run.hpp"

namespace tumble::contact::detail {

/// Two bodies, or a body and a wall, that will meet; or a body that will have slid to its end.
struct ContactEvent {
  int body, other, wall;     ///< other is -1 for a wall, wall is -1 for a body; for an end both are
  int flight, other_flight;  ///< how many flights they had begun when this was predicted
  collide::Meeting meeting;

  double t() const { return meeting.t; }
  bool is_end_of_slide() const { return other < 0 && wall < 0; }
  /// Later events have lower priority; of those at one time, that of the smallest numbers is first.
  friend bool operator<(const ContactEvent& a, const ContactEvent& b) {
    return std::tuple(-a.t(), -a.body, -a.other, -a.wall) <
           std::tuple(-b.t(), -b.body, -b.other, -b.wall);
  }
};

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
    queue_ = {};
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
    for (; !queue_.empty(); queue_.pop()) {
      const ContactEvent& event = queue_.top();
      if (event.flight != of(event.body).number) continue;
      if (event.other >= 0 && event.other_flight != of(event.other).number) continue;
      event_ = event;
      queue_.pop();
      return true;
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
    predict_own(i, t);
    predict_pairs(i, t);
  }

  /// What happens to a body by itself.
  void predict_own(int i, double t) {
    predict_walls(i, t);
    if (of(i).stops <= end_) queue_.push({i, -1, -1, of(i).number, 0, {true, of(i).stops}});
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
      if (above <= 0)
        add({i, -1, w, of(i).number, 0,
             collide::first_meeting(moving(i), wall, t, end_, tolerance(i))});
    }
  }

  void predict_pairs(int i, double t) {
    grid_.overlapping(i, [&](int j) { predict_pair(std::min(i, j), std::max(i, j), t); });
  }

  void predict_pair(int i, int j, double t) {
    if (rests(of(i)) && rests(of(j))) return;
    add({i, j, -1, of(i).number, of(j).number,
         collide::first_meeting(moving(i), moving(j), t, end_,
                                std::max(tolerance(i), tolerance(j)))});
  }

  void add(const ContactEvent& event) {
    queries_ += event.meeting.queries;
    if (event.meeting.found) queue_.push(event);
  }

  const ContactScene& scene_;
  double tolerance_, begin_ = 0, end_ = 0;
  std::vector<tumble::detail::FreeFlow> flows_;
  std::vector<PrincipalAxes> axes_;
  std::vector<Leg> flights_;
  collide::BoundsGrid grid_{0, 1};  ///< what each body passes in this window
  std::priority_queue<ContactEvent> queue_;
  ContactEvent event_{};
  std::int64_t queries_ = 0;
};

}  // namespace tumble::contact::detail
