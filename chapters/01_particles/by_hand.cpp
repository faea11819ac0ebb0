/// @file
/// What fits on paper: the rates of two particles on a spring, and one step of each method.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "methods.hpp"
#include "parts.hpp"
#include "support/svg.hpp"
#include "tumble/particles.hpp"

namespace particles_chapter {

namespace {

std::string short_number(double value, int digits = 4) {
  return support::svg_number(value, digits);
}

// ── Two particles on a spring ──

const std::array<particles::Particle<double>, 2>& paper_particles() {
  static const std::array<particles::Particle<double>, 2> both{
      {{2, Vec3(3, 0, 4), Vec3(0, 0, 5)}, {1, Vec3::Zero(), Vec3::Zero()}}};
  return both;
}

Eigen::Matrix<double, 12, 1> paper_rates() {
  const particles::UniformGravity weight{{0, 0, -10}};  // g rounded, for paper
  const particles::Spring spring{0, 1, 10, 2, 4};       // stiffness, damping, length at rest
  return particles::ParticleSystem(paper_particles(), weight, spring)
      .dydt(0, particles::flatten(paper_particles()));
}

}  // namespace

Table dydt_by_hand_table() {
  Table table({"place", "number", "y", "its rate"});
  const std::array<const char*, 4> names{"x₀", "v₀", "x₁", "v₁"};
  const Eigen::Matrix<double, 12, 1> y = particles::flatten(paper_particles()),
                                     rate = paper_rates();
  for (Eigen::Index i = 0; i < 12; ++i)
    table.add({std::to_string(i),
               std::string(names[static_cast<std::size_t>(i / 3)]) + " along " + "xyz"[i % 3],
               short_number(y[i]), short_number(rate[i])});
  return table;
}

// ── One step of each method, for a mass on a spring ──

namespace {

/// y = (x, v), with a mass of 1 kg and a spring of 1 N/m.
Eigen::Vector2d swing(double, const Eigen::Vector2d& y) { return {y[1], -y[0]}; }

const Eigen::Vector2d swing_start(1, 0);
constexpr double paper_step = 0.1;

}  // namespace

Table slopes_by_hand_table() {
  Table table({"slope", "at the time", "x there", "v there", "rate of x", "rate of v"});
  const std::array<std::array<const char*, 2>, 4> names{
      std::array<const char*, 2>{"k₁", "0"}, {"k₂", "0.05"}, {"k₃", "0.05"}, {"k₄", "0.1"}};
  std::size_t slope = 0;
  const auto noted = [&](double t, const Eigen::Vector2d& y) {
    const Eigen::Vector2d rate = swing(t, y);
    table.add({names[slope][0], names[slope][1], short_number(y[0], 6), short_number(y[1], 6),
               short_number(rate[0], 6), short_number(rate[1], 6)});
    ++slope;
    return rate;
  };
  Rk4::step(noted, 0., swing_start, paper_step);
  return table;
}

Table steps_by_hand_table() {
  Table table({"method", "x", "v", "x² + v²"});
  const auto add = [&](const std::string& name, const Eigen::Vector2d& y) {
    table.add(
        {name, short_number(y[0], 8), short_number(y[1], 8), short_number(y.squaredNorm(), 12)});
  };
  for_each_method([&](const std::string& name, auto method, int) {
    add(name, decltype(method)::step(swing, 0., swing_start, paper_step));
  });
  add("exact", {std::cos(paper_step), -std::sin(paper_step)});
  return table;
}

}  // namespace particles_chapter
