/// @file
/// Boxes that lie along a body, seen from the side or from above: where the principal axes are
/// right, where they are not, and how a turn changes the volume.

#include "common.hpp"
#include "parts.hpp"
#include "support/plot.hpp"

namespace bounding_boxes_chapter {

namespace {

/// The four corners of a box of which one edge points at the viewer, who sees the axes i and j.
std::vector<Vec2> rectangle(const boxes::OrientedBox& box, int i, int j, int viewed) {
  int edge = 0;  // the one along the line of sight
  box.R.row(viewed).cwiseAbs().maxCoeff(&edge);
  const auto side = [&](int k) -> Vec2 { return Vec2(box.R(i, k), box.R(j, k)) * box.size[k] / 2; };
  const Vec2 middle(box.centre[i], box.centre[j]), a = side((edge + 1) % 3),
                                                   b = side((edge + 2) % 3);
  return {middle + a + b, middle + a - b, middle - a - b, middle - a + b, middle + a + b};
}

}  // namespace

// ── A racket on a court ──

std::string lies_figure() {
  support::Sketch sketch(600, 400, "A racket that lies askew, and two boxes around it", 20);
  sketch.look({212, 200, 520});
  const Points points = turned(racket().points(), axis_rotation(2, 0.6));
  std::vector<Vec2> seen;
  for (const Vec3& p : points)
    seen.emplace_back(p.head<2>() - boxes::aligned_box(points).centre.head<2>());
  boxes::OrientedBox upright = boxes::aligned_box(points), along = boxes::principal_box(points);
  along.centre -= upright.centre;
  upright.centre.setZero();
  sketch.specks(seen, "ink", 1.5);
  sketch.curve(rectangle(upright, 0, 1, 2), {"c0", 2});
  sketch.curve(rectangle(along, 0, 1, 2), {"c1", 2});
  Vec2 mean = Vec2::Zero();
  for (const Vec2& p : seen) mean += p / static_cast<double>(seen.size());
  Mat3 scatter = Mat3::Zero();
  for (const Vec2& p : seen) scatter.topLeftCorner<2, 2>() += (p - mean) * (p - mean).transpose();
  for (const int k : {0, 1, 2}) {
    const Vec2 axis = along.R.col(k).head<2>();
    if (axis.norm() < 0.5) continue;
    const double spread = std::sqrt(axis.dot(scatter.topLeftCorner<2, 2>() * axis) /
                                    static_cast<double>(seen.size()));
    for (const double sign : {-1., 1.})
      sketch.arrow(mean, mean + sign * spread * axis, {"c2", 2.6});
  }
  sketch.dot(mean, "c2", 5);
  const Vec2 corner = upright.size.head<2>().cwiseProduct(Vec2(-0.5, 0.5));
  sketch.words(corner, {0, -10}, "along the axes", "c0");
  sketch.words({0.13, -0.27}, {0, 0}, "along the racket", "c1");
  return sketch.svg();
}

// ── The mug from the side and from above ──

namespace {

/// What a viewer sees of a mesh who looks along the third axis, as triangles.
std::vector<std::vector<Vec2>> silhouette(const PolygonMesh& mesh, int right, int up) {
  std::vector<std::vector<Vec2>> triangles;
  for_each_triangle(mesh, [&](int, const std::array<int, 3>& t) {
    std::vector<Vec2> corners;
    for (const int v : t) corners.emplace_back(mesh.vertex(v)[right], mesh.vertex(v)[up]);
    const Vec2 a = corners[1] - corners[0], b = corners[2] - corners[0];
    if (a.x() * b.y() - a.y() * b.x() > 1e-9) triangles.push_back(corners);
  });
  return triangles;
}

}  // namespace

std::string sides_figure() {
  support::Sketch sketch(760, 410, "Three boxes around a mug", 20);
  const Vec3 middle = bounds(mug().mesh).center();
  constexpr double scale = 2250;
  const auto look = [&](double x, int up) {
    sketch.look({x - scale * middle.x(), 178 + scale * middle[up], scale});
    sketch.curves(silhouette(mug().mesh, 0, up), {"solid", 1.2, 1, 1});
  };
  const auto draw = [&](const boxes::OrientedBox& box, int up, const std::string& colour,
                        const std::string& name, double down) {
    sketch.curve(rectangle(box, 0, up, 3 - up), {colour, 2.4});
    sketch.words({middle.x(), middle[up]}, {0, down}, name + times(box.volume() / mug().volume()),
                 colour, "middle");
  };
  const boxes::OrientedBox upright = boxes::aligned_box(mug().points());
  look(200, 2);
  draw(upright, 2, "c0", "along the axes: ", 200);
  draw(boxes::principal_box(mug().points()), 2, "c6", "principal: ", 225);
  look(572, 1);
  draw(upright, 1, "c0", "along the axes: ", 200);
  draw(boxes::small_oriented_box(mug().points()), 1, "c2", "smaller: ", 225);
  return sketch.svg();
}

// ── The volume while the box is turned ──

namespace {

/// By how much a box of the mug is turned about z, from 0° to 90°, where it looks the same again.
double turn_of(const boxes::OrientedBox& box) {
  int edge = 0;
  box.R.row(0).cwiseAbs().maxCoeff(&edge);
  const double angle = std::atan(box.R(1, edge) / box.R(0, edge));
  return angle < 0 ? angle + pi / 2 : angle;
}

}  // namespace

std::string valley_figure() {
  support::Plot plot{"boxes of a mug",
                     {"turned about the upright axis by [°]", support::Scale::linear},
                     {"volume of the box, in volumes of the mug", support::Scale::linear},
                     {}};
  const auto volume = [](const boxes::OrientedBox& box) { return box.volume() / mug().volume(); };
  support::Series curve{"any turn", {}, {}};
  for (int i = 0; i <= 400; ++i) {
    curve.x.push_back(i / 4.0);
    curve.y.push_back(
        volume(boxes::box_around(mug().points(), axis_rotation(2, i / 4.0 * degree))));
  }
  plot.series.push_back(curve);
  const boxes::OrientedBox upright = boxes::aligned_box(mug().points());
  plot.series.push_back({"along the axes", {0}, {volume(upright)}, support::Look::dots});
  const boxes::OrientedBox smaller = boxes::small_oriented_box(mug().points());
  plot.series.push_back(
      {"smaller", {turn_of(smaller) / degree}, {volume(smaller)}, support::Look::dots});
  const double mirrored = pi / 2 - turn_of(smaller);
  plot.series.push_back({"handle in the next corner",
                         {mirrored / degree},
                         {volume(boxes::box_around(mug().points(), axis_rotation(2, mirrored)))},
                         support::Look::dots});
  return support::to_svg(plot);
}

Table descent_table() {
  Table table({"object", "along the axes", "down from there", "principal", "down from there"});
  for (const Thing& body : things()) {
    const auto text = [&body](const boxes::OrientedBox& box) {
      return times(box.volume() / body.volume());
    };
    const boxes::OrientedBox upright = boxes::aligned_box(body.points()),
                             main = boxes::principal_box(body.points());
    table.add({body.name, text(upright), text(boxes::refined_box(body.points(), upright)),
               text(main), text(boxes::refined_box(body.points(), main))});
  }
  return table;
}

}  // namespace bounding_boxes_chapter
