// The tumbling itself: spin about the middle axis does not last, the body turns over,
// and over again.
#include <iostream>

#include "support/plot.hpp"
#include "tour/motion.hpp"
#include "tumble/ode.hpp"
#include "tumble/quaternion.hpp"

namespace tumble::tour {
namespace {

std::vector<Moment> simulate(const RigidBody<>& body) {
  const Mat3 principal = principal_axes(body.I_body()).R;
  const RigidBodyRhs motion(body);
  PackedState<double> y = pack(spinning(body, flight_spin));
  std::vector<Moment> list;
  for (int i = 0; i <= moments; ++i) {
    const double t = flight_time * i / moments;
    if (i > 0)
      y = integrate_adaptive<Dop853>(motion, y, flight_time * (i - 1) / moments, t, {1e-12, 1e-12})
              .y;
    const RigidBodyState<> state = unpack<double>(y);
    const Vec3 omega_body = to_matrix(state.q).transpose() * derived(body, state).omega;
    list.push_back({t, state, principal.transpose() * omega_body, kinetic_energy(body, state)});
  }
  return list;
}

support::Plot spin_plot(const std::vector<Moment>& motion) {
  support::Plot plot{"angular velocity in the body", {"time [s]"}, {"rad/s"}, {}};
  const char* names[] = {"axis of least inertia", "middle axis", "axis of largest inertia"};
  for (int axis = 0; axis < 3; ++axis) {
    support::Series series{names[axis], {}, {}};
    for (const Moment& m : motion) {
      series.x.push_back(m.t);
      series.y.push_back(m.omega_principal[axis]);
    }
    plot.series.push_back(series);
  }
  return plot;
}

support::Table motion_table(const std::vector<Moment>& motion) {
  support::Table table({"t [s]", "x", "y", "z [m]", "qw", "qx", "qy", "qz", "Px", "Py",
                        "Pz [kg m/s]", "Lx", "Ly", "Lz [kg m²/s]", "ω least", "ω middle",
                        "ω largest [rad/s]", "energy [J]"});
  for (const Moment& m : motion) {
    std::vector<std::string> row{support::number(m.t, 6)};
    const PackedState<double> y = pack(m.state);
    for (const double value : y) row.push_back(support::number(value, 15));
    for (const double value : m.omega_principal) row.push_back(support::number(value, 15));
    row.push_back(support::number(m.energy, 15));
    table.add(row);
  }
  return table;
}

}  // namespace

RigidBodyState<> spinning(const RigidBody<>& body, const Spin& spin) {
  const PrincipalAxes axes = principal_axes(body.I_body());
  const Vec3 omega = spin.rate * Vec3(spin.tilt, 1, -spin.tilt);
  // q⁻¹ maps the world's axes to the principal axes in the body.
  const Quat q = from_matrix(axes.R).conjugate();
  return state_of_motion<double>(body, Vec3::Zero(), q, Vec3::Zero(), omega);
}

void show_motion(const Subject& subject, Output& output) {
  const RigidBody<> body(subject.exact);
  progress("twelve seconds of tumbling");
  const std::vector<Moment> motion = simulate(body);
  const std::vector<double> times = turnovers(motion);

  support::Table table(
      {"t [s]", "ω least", "ω middle", "ω largest [rad/s]", "|L| change", "energy change"});
  const double L0 = motion.front().state.L.norm(), E0 = motion.front().energy;
  for (std::size_t i = 0; i < motion.size(); i += moments / 12) {
    const Moment& m = motion[i];
    table.add({support::number(m.t), support::number(m.omega_principal[0]),
               support::number(m.omega_principal[1]), support::number(m.omega_principal[2]),
               support::error_number(std::abs(m.state.L.norm() / L0 - 1)),
               support::error_number(std::abs(m.energy / E0 - 1))});
  }
  output.show("Tumbling: one turn a second about the middle axis, 0.01 rad off it", table,
              "motion");
  std::cout << '\n';
  if (times.empty()) {
    std::cout << "  It does not turn over in 12 s: two of its moments are equal, or nearly so.\n";
  } else {
    std::cout << "  It turns over at";
    for (const double t : times) std::cout << ' ' << support::number(t) << " s";
    std::cout << ": spin about the middle axis is unstable.\n";
  }
  output.write("motion_samples.csv", motion_table(motion).csv());
  output.write("spin.svg", support::to_svg(spin_plot(motion)));
  output.write("tumbling.svg", film_strip(subject, motion));
}

}  // namespace tumble::tour
