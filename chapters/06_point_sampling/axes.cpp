/// @file
/// The same body about other points, and far from the origin of the world.

#include "common.hpp"
#include "parts.hpp"
#include "support/plot.hpp"
#include "support/view.hpp"

namespace point_sampling_chapter {

// ── Parallel axes ──

namespace {

const objects::Object& racket_object = objects::all[2];

/// The racket of chapter 5, its handle along −x, by its finest mesh.
PolygonMesh racket_mesh() { return racket_object.mesh(racket_object.fine); }

const MassProperties& racket() {
  static const MassProperties body = mesh_mass_properties(racket_mesh(), racket_object.density);
  return body;
}

/// Where it is held, 10 cm from the end of the handle [m].
double hand() { return bounds(racket_mesh()).min().x() + 0.1; }

std::string gram_square_metres(double I) { return number(1000 * I, 4) + " g m²"; }

}  // namespace

Table racket_table() {
  Table table({"about an axis through", "off the centre of mass", "I_yy", "added"});
  const Eigen::AlignedBox3d box = bounds(racket_mesh());
  const double end = box.min().x(), tip = box.max().x();  // [m]
  const double mass = racket().mass, centre = racket().centre.x();
  const auto about = [&](double x) { return inertia_about(racket(), {x, 0, 0})(1, 1); };
  const auto add = [&](const std::string& name, double x) {
    table.add({name, number(1000 * std::abs(x - centre)) + " mm", gram_square_metres(about(x)),
               percent(1 - about(centre) / about(x), 3)});
  };
  add("the centre of mass", centre);
  add("the hand, 10 cm from the end", hand());
  add("the end of the handle", end);
  add("the tip", tip);
  table.add({"the end, in one step from the hand", "",
             gram_square_metres(about(hand()) + mass * 0.1 * 0.1), "wrong"});
  return table;
}

Table twice_table() {
  Table table({"mass of the racket", "I_yy about its centre of mass", "twice that is at"});
  const double I = racket().inertia(1, 1);
  table.add({number(1000 * racket().mass, 4) + " g", gram_square_metres(I),
             number(1000 * std::sqrt(I / racket().mass), 4) + " mm from it"});
  return table;
}

std::string swing_figure() {
  support::Sketch sketch(760, 330, "A tennis racket and two axes");
  const PolygonMesh drawn = racket_object.mesh(racket_object.for_drawings);
  const Eigen::AlignedBox3d box = bounds(drawn);
  constexpr double scale = 980;
  const support::Window window{30 - scale * box.min().x(), 168, scale};
  sketch.drawing(support::draw_mesh(drawn, Mat3::Identity(), {window.x, window.y, scale}));
  sketch.look(window);
  const Vec2 p(hand(), 0), c(racket().centre.x(), 0), point(box.max().x() - 0.07, 0.118);
  for (const Vec2& at : {p, c}) {
    sketch.curve({at - Vec2(0, 0.135), at + Vec2(0, 0.135)}, {"ink", 1.4});
    sketch.dot(at, "ink", 4.5);
  }
  sketch.words(p, {-9, -120}, "p, the hand", "ink", "end");
  sketch.words(c, {-9, -120}, "c, the centre of mass", "ink", "end");
  sketch.arrow(p, c, {"c1", 2.6});
  sketch.words((p + c) / 2, {0, -12}, "d", "c1", "middle");
  sketch.arrow(c, point, {"c2", 2.6});
  sketch.words(c + 0.3 * (point - c), {2, 26}, "r", "c2");
  sketch.arrow(p, point, {"c0", 2.6});
  sketch.words(p + 0.44 * (point - p), {-6, -12}, "d + r", "c0", "end");
  const Vec2 corner(box.min().x(), -0.14);
  sketch.arrow(corner, corner + Vec2(0.05, 0), {"faint", 1.4});
  sketch.arrow(corner, corner + Vec2(0, 0.05), {"faint", 1.4});
  sketch.words(corner + Vec2(0.05, 0), {5, 5}, "x", "faint");
  sketch.words(corner + Vec2(0, 0.05), {-5, -6}, "y", "faint");
  return sketch.svg();
}

// ── Far from the origin ──

namespace {

/// Points on a grid of 2⁻²⁰ m: they can be moved by 2²⁰ m or 2³⁰ m without being rounded.
std::vector<PointMass> points_of_mug() {
  std::vector<PointMass> points;
  sampling::RandomPoints random(4000, 3);
  const Eigen::AlignedBox3d box = mug_solid().bounds();
  while (points.size() < 300) {
    const Vec3 p = box.min() + random.next().cwiseProduct(box.sizes());
    if (mug_solid().contains(p)) points.push_back({0.001, (p * 0x1p20).array().round() * 0x1p-20});
  }
  return points;
}

/// About the origin of the world, then moved to the centre of mass.
Mat3 by_way_of_the_origin(const std::vector<PointMass>& points) {
  Mat3 about_origin = Mat3::Zero();
  Vec3 first = Vec3::Zero();
  double mass = 0;
  for (const PointMass& p : points) {
    about_origin += point_inertia(p.mass, p.position);
    first += p.mass * p.position;
    mass += p.mass;
  }
  return inertia_about_centre(about_origin, mass, first / mass);
}

/// Differences first: the arms from the centre of mass, then their squares.
Mat3 by_differences(const std::vector<PointMass>& points) {
  const Vec3 centre = centre_of_mass(points);
  Mat3 sum = Mat3::Zero();
  for (const PointMass& p : points) sum += point_inertia(p.mass, p.position - centre);
  return sum;
}

}  // namespace

std::string far_figure() {
  support::Plot plot{"300 points of a mug",
                     {"distance from the origin [m]", support::Scale::log},
                     {"error of the inertia", support::Scale::log},
                     {}};
  const std::vector<PointMass> here = points_of_mug();
  const Mat3 truth = mass_properties(here).inertia;
  const auto add = [&](const std::string& name, auto&& find) {
    support::Series series{name, {}, {}};
    for (int k = -2; k <= 26; k += 2) {
      const double distance = std::ldexp(1.0, k);
      std::vector<PointMass> there = here;
      for (PointMass& p : there) p.position += Vec3(distance, 0, 0);
      series.x.push_back(distance);
      series.y.push_back(std::max(inertia_error(find(there), truth), 1e-17));
    }
    plot.series.push_back(series);
  };
  add("by way of the origin", by_way_of_the_origin);
  add("differences first", by_differences);
  return support::to_svg(plot);
}

}  // namespace point_sampling_chapter
