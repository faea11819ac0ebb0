#pragma once
/// @file
/// A net of knots and springs, nailed at two corners: its state and its right-hand side.

#include <vector>

#include "thrown_ball.hpp"
#include "tumble/particles.hpp"

namespace particles_chapter {

/// What a net is made of.
struct Net {
  int columns, rows;
  double damping;           // of a thread [N s/m]
  double mesh = 0.1;        // from knot to knot, and the threads' rest length [m]
  double mass = 0.005;      // of a knot [kg]
  double stiffness = 1000;  // of a thread [N/m]

  int knots() const { return columns * rows; }
  int knot(int column, int row) const { return row * columns + column; }
};

/// Level, at rest; rows run away from the nails at the ends of row 0.
inline std::vector<particles::Particle<double>> level(const Net& net) {
  std::vector<particles::Particle<double>> particles;
  for (int row = 0; row < net.rows; ++row)
    for (int column = 0; column < net.columns; ++column)
      particles.push_back({net.mass, Vec3(column, row, 0) * net.mesh, Vec3::Zero()});
  return particles;
}

inline std::vector<particles::Spring> threads(const Net& net) {
  std::vector<particles::Spring> springs;
  const auto tie = [&](int i, int j) {
    springs.push_back({i, j, net.stiffness, net.damping, net.mesh});
  };
  for (int row = 0; row < net.rows; ++row)
    for (int column = 0; column < net.columns; ++column) {
      if (column + 1 < net.columns) tie(net.knot(column, row), net.knot(column + 1, row));
      if (row + 1 < net.rows) tie(net.knot(column, row), net.knot(column, row + 1));
    }
  return springs;
}

/// All springs as one force.
struct Springs {
  std::vector<particles::Spring> list;

  void operator()(double t, const particles::ParticlesView<double>& particles,
                  const particles::ForceSums<double>& push) const {
    for (const particles::Spring& spring : list) spring(t, particles, push);
  }
};

using Knots = Eigen::VectorXd;

/// Where a knot's position starts in the state; its velocity is three places on.
inline Eigen::Index place(int knot) { return 6 * static_cast<Eigen::Index>(knot); }

inline auto forces_on(const Net& net) {
  return particles::ParticleSystem(level(net), particles::UniformGravity{{0, 0, -g}},
                                   Springs{threads(net)});
}

/// The net's right-hand side. A knot that is nailed down does not change: its rates are 0.
inline auto hanging(const Net& net) {
  return [system = forces_on(net), net](double t, const Knots& y) -> Knots {
    Knots ydot = system.dydt(t, y);
    for (const int nailed : {net.knot(0, 0), net.knot(net.columns - 1, 0)})
      ydot.segment<6>(place(nailed)).setZero();
    return ydot;
  };
}

}  // namespace particles_chapter
