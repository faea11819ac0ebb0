#pragma once
/// @file
/// A ball that is dropped and loses nothing, by formula and by steps.

#include "common.hpp"

namespace contact_chapter {

/// Height and velocity upwards.
struct Falling {
  double z, v;
};

inline constexpr double dropped_from = 5;  ///< [m]

inline double energy_of(const Falling& ball) { return gravity * ball.z + ball.v * ball.v / 2; }

/// By flights, each a formula that ends at its contact.
/// @param contacts how many there were
inline Falling by_flights(double t, int& contacts) {
  const double first = std::sqrt(2 * dropped_from / gravity), speed = gravity * first;
  if (t < first) return {dropped_from - gravity * t * t / 2, -gravity * t};
  double since = t - first;
  contacts = 1;
  for (const double flight = 2 * speed / gravity; since >= flight; since -= flight) ++contacts;
  return {speed * since - gravity * since * since / 2, speed - gravity * since};
}

/// The same without a loop, as the truth: the motion repeats itself.
inline Falling in_truth(double t) {
  const double first = std::sqrt(2 * dropped_from / gravity);
  const double from_top = std::remainder(t, 2 * first);
  return {dropped_from - gravity * from_top * from_top / 2, -gravity * from_top};
}

/// When a program that takes steps turns the velocity round.
enum class Turn { when_below, before_it_would_pass };

/// Where a step of a game leads in flight: first the velocity, then the place.
inline Falling game_step(const Falling& ball, double h) {
  const double v = ball.v - h * gravity;
  return {ball.z + h * v, v};
}

/// Where the parabola leads.
inline Falling exact_step(const Falling& ball, double h) {
  return {ball.z + h * ball.v - gravity * h * h / 2, ball.v - h * gravity};
}

/// One step of a game with the floor: what is turned round is the new velocity, and the ball moves
/// by it.
inline Falling game_step_with_floor(const Falling& ball, double h, Turn turn) {
  const Falling next = game_step(ball, h);
  if (next.z >= 0) return next;
  const double v = std::abs(next.v);
  return {turn == Turn::when_below ? next.z : ball.z + h * v, v};
}

/// The same with parabolas before and after the turn.
inline Falling exact_step_with_floor(const Falling& ball, double h, Turn turn) {
  const Falling next = exact_step(ball, h);
  if (next.z >= 0) return next;
  if (turn == Turn::when_below) return {next.z, std::abs(next.v)};
  return exact_step({ball.z, std::abs(ball.v)}, h);
}

}  // namespace contact_chapter
