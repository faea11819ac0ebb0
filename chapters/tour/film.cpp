// The film strip of the tumbling: pictures, and below them the spin about the body's own axes.
#include <algorithm>
#include <array>
#include <cmath>

#include "support/plot_curve.hpp"
#include "support/svg_path.hpp"
#include "support/view.hpp"
#include "tour/motion.hpp"
#include "tumble/quaternion.hpp"

namespace tumble::tour {
namespace {

/// Where things are in the film: a row of pictures, and below it what the body's axes say, each
/// picture above its time.
struct Film {
  static constexpr double picture = 84, row = 118, pictures = 10;  // [px], [px], how many
  static constexpr double strip = picture * pictures, legend = 150, curves = 120;  // [px]
  double begin, end;                                                               ///< [s]

  double x(double t) const { return strip * (t - begin) / (end - begin); }
  double y(double omega) const { return row + curves * (0.5 - 0.42 * omega / flight_spin.rate); }
  double time(int i) const { return begin + (end - begin) * (i + 0.5) / pictures; }
};

const Moment& moment_at(const std::vector<Moment>& motion, double t) {
  return motion[static_cast<std::size_t>(std::lround(t / flight_time * moments))];
}

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
         coordinates(at.x + L.x(), at.y - L.y()) + "\" " + support::stroke_of("faint") +
         " stroke-dasharray=\"5 4\"/>\n" +
         support::draw_mesh(drawn, view * to_matrix(moment.state.q), at) +
         words(at.x, Film::row - 8, support::svg_number(moment.t, 2) + " s",
               support::fill_of("ink") + " text-anchor=\"middle\"");
}

/// Where the spin is 0, and where it is a turn per second.
std::string spin_scale(const Film& film) {
  std::string svg;
  for (const int turns : {1, 0, -1}) {
    const double y = film.y(turns * flight_spin.rate);
    svg += "<path d=\"M0 " + support::svg_number(y) + "H" + support::svg_number(Film::strip) +
           "\" " + support::stroke_of("grid") + "/>\n";
    if (turns != 0)
      svg += words(4, y + (turns > 0 ? 13 : -4), turns > 0 ? "6.28 rad/s" : "−6.28 rad/s",
                   support::fill_of("ink") + " font-size=\"11\"");
  }
  return svg;
}

/// The three numbers of the angular velocity in the body, over the time of the film, marked where
/// the pictures are.
std::string spin_curves(const Film& film, const std::vector<Moment>& motion) {
  const char* names[] = {"least", "middle", "largest"};
  std::string svg = spin_scale(film);
  svg += words(Film::strip + 10, Film::row + 4, "ω about the axis of", support::fill_of("ink"));
  for (int axis = 0; axis < 3; ++axis) {
    support::SvgPath path;
    for (const Moment& m : motion)
      if (m.t >= film.begin && m.t <= film.end)
        path.add(film.x(m.t), film.y(m.omega_principal[axis]), path.text().empty());
    const double row = Film::row + 24 + 18 * axis;
    std::vector<support::plot_detail::Pixel> marked{{Film::strip + 15, row - 4}};
    for (int i = 0; i < Film::pictures; ++i)
      marked.push_back(
          {film.x(film.time(i)), film.y(moment_at(motion, film.time(i)).omega_principal[axis])});
    const support::SeriesLook look{"c" + std::to_string(axis), axis};
    svg += "<path d=\"" + path.text() + "\" fill=\"none\" " + support::stroke_of(look.colour) +
           " stroke-width=\"1.8\"/>\n" + support::plot_detail::draw_markers(marked, look);
    svg += words(Film::strip + 24, row, names[axis] + std::string(" inertia"),
                 support::fill_of(look.colour));
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

}  // namespace

std::vector<double> turnovers(const std::vector<Moment>& motion) {
  std::vector<double> times;
  for (std::size_t i = 1; i < motion.size(); ++i)
    if (motion[i - 1].omega_principal[1] * motion[i].omega_principal[1] < 0)
      times.push_back(motion[i].t);
  return times;
}

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
  for (int i = 0; i < Film::pictures; ++i)
    svg += picture_of(drawn, view, moment_at(motion, film.time(i)),
                      {film.x(film.time(i)), Film::picture / 2 + 6, 0.5 * Film::picture / radius});
  return svg + spin_curves(film, motion) + "</svg>\n";
}

}  // namespace tumble::tour
