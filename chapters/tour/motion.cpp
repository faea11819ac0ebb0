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

constexpr Spin flight_spin{6.283185307179586,
                           0.01};   // one turn a second, nearly about the middle axis
constexpr double flight_time = 12;  // [s]
constexpr int moments = 1200;

struct Moment {
  double t;
  RigidBodyState<> state;
  Vec3 omega_principal;  ///< along the axes of the least, middle and largest moment [rad/s]
  double energy;         ///< [J]
};

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

/// Where things stand in the film: a row of pictures, and below it what the body's axes say, each
/// picture above its time.
struct Film {
  static constexpr double picture = 84, row = 118, pictures = 10;  // [px], [px], how many
  static constexpr double strip = picture * pictures, legend = 150, curves = 120;  // [px]
  double begin, end;                                                               ///< [s]

  double x(double t) const { return strip * (t - begin) / (end - begin); }
  double time(int i) const { return begin + (end - begin) * (i + 0.5) / pictures; }
};

/// The seconds around the first turnover, or the first ones if it has none.
Film film_of(const std::vector<Moment>& motion) {
  constexpr double long_enough = 3;  // [s]
  const std::vector<double> times = turnovers(motion);
  const double begin = times.empty() ? 0 : std::max(0.0, times.front() - long_enough / 2);
  return {begin, begin + long_enough};
}

std::string coordinates(double x, double y) {
  return support::svg_number(x) + " " + support::svg_number(y);
}

std::string words(double x, double y, const std::string& text, const std::string& attributes) {
  return "<text x=\"" + support::svg_number(x) + "\" y=\"" + support::svg_number(y) + "\" " +
         attributes + ">" + text + "</text>\n";
}

/// The body at a moment, and behind it the direction of L, which never changes.
std::string picture_of(const PolygonMesh& drawn, const Mat3& view, const Moment& moment,
                       const support::Placement& at) {
  const Vec3 L = view * moment.state.L.normalized() * 0.55 * Film::picture;
  return "<path d=\"M" + coordinates(at.x - L.x(), at.y + L.y()) + "L" +
         coordinates(at.x + L.x(), at.y - L.y()) +
         "\" stroke=\"var(--faint)\" stroke-dasharray=\"5 4\"/>\n" +
         support::draw_mesh(drawn, view * to_matrix(moment.state.q), at) +
         words(at.x, Film::row - 8, support::svg_number(moment.t, 2) + " s",
               "fill=\"var(--ink)\" text-anchor=\"middle\"");
}

/// The three numbers of the angular velocity in the body, over the time of the film.
std::string spin_curves(const Film& film, const std::vector<Moment>& motion) {
  const char* names[] = {"least", "middle", "largest"};
  const double middle = Film::row + Film::curves / 2,
               scale = 0.42 * Film::curves / flight_spin.rate;
  std::string svg = "<path d=\"M0 " + support::svg_number(middle) + "H" +
                    support::svg_number(Film::strip) + "\" stroke=\"var(--grid)\"/>\n";
  svg += words(Film::strip + 10, Film::row + 4, "ω about the axis of", "fill=\"var(--ink)\"");
  for (int axis = 0; axis < 3; ++axis) {
    std::string path;
    for (const Moment& m : motion)
      if (m.t >= film.begin && m.t <= film.end)
        path += (path.empty() ? "M" : "L") +
                coordinates(film.x(m.t), middle - scale * m.omega_principal[axis]);
    const std::string colour = "var(--c" + std::to_string(axis == 1 ? 1 : 2 * axis) + ")";
    svg +=
        "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"1.8\"/>\n";
    svg += words(Film::strip + 10, Film::row + 24 + 18 * axis,
                 names[axis] + std::string(" inertia"), "fill=\"" + colour + "\"");
  }
  return svg;
}

/// The mesh about its centre of mass.
/// @param radius of the sphere about it, given back [m]
PolygonMesh centred(PolygonMesh mesh, const Vec3& centre, double& radius) {
  radius = 0;
  for (Vec3& v : mesh.vertices) {
    v -= centre;
    radius = std::max(radius, v.norm());
  }
  return mesh;
}

/// The body through its first turnover, and its angular velocity meanwhile.
std::string film_strip(const Subject& subject, const std::vector<Moment>& motion) {
  double radius = 0;
  const PolygonMesh drawn = centred(subject.drawing, subject.exact.centre, radius);
  // The spin axis, y of the world, stands upright in the picture, seen from a little above.
  const Mat3 view =
      (Eigen::AngleAxisd(0.35, Vec3::UnitX()) * Eigen::AngleAxisd(-0.5, Vec3::UnitY()))
          .toRotationMatrix();
  const Film film = film_of(motion);
  std::string svg = support::svg_open(Film::strip + Film::legend, Film::row + Film::curves,
                                      subject.name + " turning over");
  for (int i = 0; i < Film::pictures; ++i) {
    const auto index = static_cast<std::size_t>(std::lround(film.time(i) / flight_time * moments));
    svg += picture_of(drawn, view, motion[index],
                      {film.x(film.time(i)), Film::picture / 2 + 6, 0.5 * Film::picture / radius});
  }
  return svg + spin_curves(film, motion) + "</svg>\n";
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
