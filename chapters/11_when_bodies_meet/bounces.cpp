/// @file
/// A ball with back-spin over the floor.

#include "parts.hpp"
#include "spinning_ball.hpp"
#include "support/two_axes.hpp"

namespace contact_chapter {

namespace {

constexpr int drawn_contacts = 5;

/// From contact to contact: where it lands, and the flight to there.
struct Flight {
  std::vector<Vec2> path;
  SpinningBall landing, after;
};

std::vector<Flight> flights_of(SpinningBall ball) {
  std::vector<Flight> flights;
  for (int k = 0; k <= drawn_contacts; ++k) {
    Flight flight;
    const double duration = flight_time(ball);
    for (int i = 0; i <= 40; ++i) flight.path.push_back(in_flight(ball, duration * i / 40).x);
    flight.landing = in_flight(ball, duration);
    flight.after = ball = after_floor(flight.landing, 0.8, 0.3);
    flights.push_back(flight);
  }
  return flights;
}

void draw_ball(Sketch& sketch, const Vec2& centre) {
  std::vector<Vec2> rim;
  for (int i = 0; i <= 48; ++i) {
    const double angle = 2 * pi * i / 48;
    rim.emplace_back(centre + ball_radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  sketch.curve(rim, {"c2", 1.4, 1, 0.1});
}

}  // namespace

std::string bounces_figure() {
  Sketch sketch(760, 420, "A ball with back-spin jumps to the right, and comes back");
  sketch.look({50, 330, 370});
  const SpinningBall start{{0, 0.72}, {3, 0}, -10 / ball_radius};
  sketch.curve({{-0.1, 0}, {1.88, 0}}, {"ink", 1.8});
  draw_ball(sketch, start.x);
  int contact = 0;
  for (const Flight& flight : flights_of(start)) {
    sketch.curve(flight.path, {flight.landing.v.x() < 0 ? "c1" : "c0", 2});
    if (++contact > drawn_contacts) break;
    const Vec2 touch = flight.landing.x - Vec2(0, ball_radius);
    draw_ball(sketch, flight.landing.x);
    sketch.words(touch, {0, 24}, std::to_string(contact), "ink", "middle");
    sketch.words(touch, {0, 48}, rounded(slip_of(flight.landing), 1), "c3", "middle");
    sketch.words(touch, {0, 72}, rounded(slip_of(flight.after), 1), "c3", "middle");
  }
  sketch.words({0, 0}, {-34, 24}, "contact");
  sketch.words({0, 0}, {-34, 48}, "slip before [m/s]", "c3");
  sketch.words({0, 0}, {-34, 72}, "slip after [m/s]", "c3");
  sketch.look({40, 240, 50});
  support::draw_two_axes(sketch, 1, {"x", "z"});
  return sketch.svg();
}

}  // namespace contact_chapter
