// The tumbling itself: spin about the middle axis does not last, the body turns over,
// and over again.
#include <iostream>

#include "support/plot.hpp"
#include "support/view.hpp"
#include "tour/tour.hpp"
#include "tumble/ode.hpp"
#include "tumble/quaternion.hpp"

namespace tumble::tour {
namespace {

constexpr Spin start_spin{6.283185307179586,
                          0.01};  // one turn a second, nearly about the middle axis
constexpr double duration = 12;   // [s]
constexpr int moments = 1200;

struct Moment {
  double t;
  RigidBodyState<> state;
  Vec3 omega_principal;  ///< along the axes of the least, middle and largest moment [rad/s]
  double energy;         ///< [J]
};

std::vector<Moment> simulate(const RigidBody<>& body) {
  const Mat3 principal = principal_axes(body.I_body()).R;
  const RigidBodyMotion motion(body);
  PackedState<double> y = pack(spinning(body, start_spin));
  std::vector<Moment> list;
  for (int i = 0; i <= moments; ++i) {
    const double t = duration * i / moments;
    if (i > 0)
      y = integrate_adaptive<Dop853>(motion, y, duration * (i - 1) / moments, t, {1e-12, 1e-12}).y;
    const RigidBodyState<> state = unpack<double>(y);
    const Vec3 omega_body = to_matrix(state.q).transpose() * derived(body, state).omega;
    list.push_back({t, state, principal.transpose() * omega_body, kinetic_energy(body, state)});
  }
  return list;
}

/// The times when the spin along the middle axis changes its sign: half-way through each turnover.
std::vector<double> turnovers(const std::vector<Moment>& motion) {
  std::vector<double> times;
  for (std::size_t i = 1; i < motion.size(); ++i)
    if (motion[i - 1].omega_principal[1] * motion[i].omega_principal[1] < 0)
      times.push_back(motion[i].t);
  return times;
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

/// The drawing of a moment: the body, and behind it the direction of L, which never changes.
std::string frame(const PolygonMesh& drawn, const Mat3& view, const Moment& moment, double size,
                  const support::Placement& at) {
  const Vec3 L = view * moment.state.L.normalized() * 0.5 * size;
  const auto number = [](double value) { return support::svg_number(value); };
  return "<path d=\"M" + number(at.x - L.x()) + " " + number(at.y + L.y()) + "L" +
         number(at.x + L.x()) + " " + number(at.y - L.y()) +
         "\" stroke=\"var(--c1)\" stroke-dasharray=\"5 4\"/>\n" +
         support::draw_mesh(drawn, view * to_matrix(moment.state.q), at) + "<text x=\"" +
         number(at.x) + "\" y=\"" + number(at.y + size / 2 + 12) +
         "\" fill=\"var(--ink)\" text-anchor=\"middle\">" + support::svg_number(moment.t, 2) +
         " s</text>\n";
}

/// Pictures of the body through its first turnover (or the first seconds, if it has none).
std::string film_strip(const Subject& subject, const std::vector<Moment>& motion) {
  constexpr int columns = 6, rows = 2;
  constexpr double size = 160, caption = 24, apart = 0.25;  // [px], [px], [s]
  const std::vector<double> times = turnovers(motion);
  const double half = apart * (columns * rows - 1) / 2,
               middle = times.empty() ? half : times.front();
  PolygonMesh drawn = subject.drawing;
  double radius = 0;
  for (Vec3& v : drawn.vertices) {
    v -= subject.exact.centre;
    radius = std::max(radius, v.norm());
  }
  // The spin axis, y of the world, stands upright in the picture, seen from a little above.
  const Mat3 view =
      (Eigen::AngleAxisd(0.35, Vec3::UnitX()) * Eigen::AngleAxisd(-0.5, Vec3::UnitY()))
          .toRotationMatrix();
  std::string svg =
      support::svg_open(columns * size, rows * (size + caption), subject.name + " turning over");
  for (int i = 0; i < columns * rows; ++i) {
    const double t = std::max(0.0, middle - half) + apart * i;
    const auto index =
        std::min(motion.size() - 1, static_cast<std::size_t>(std::lround(t / duration * moments)));
    svg += frame(drawn, view, motion[index], size,
                 {size * (i % columns + 0.5), (size + caption) * (i / columns) + size / 2,
                  0.46 * size / radius});
  }
  return svg + "</svg>\n";
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
