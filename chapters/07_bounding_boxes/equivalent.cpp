/// @file
/// The box that has the mass and the inertia of a body, beside the one around it.

#include "common.hpp"
#include "parts.hpp"
#include "support/view.hpp"

namespace bounding_boxes_chapter {

namespace {

/// The full box with the mass and the inertia tensor of a body: it always exists, and only once.
boxes::OrientedBox equivalent_box(const MassProperties& body) {
  const PrincipalAxes axes = principal_axes(body.inertia);
  const Vec3 squares = 6 / body.mass * (Vec3::Constant(axes.moments.sum()) - 2 * axes.moments);
  return {body.centre, axes.R, squares.cwiseMax(0).cwiseSqrt()};
}

/// A box as lines: those at the farthest corner are behind the body.
class BoxLines {
 public:
  BoxLines(const boxes::OrientedBox& box, const Mat3& to_viewer, const support::Placement& at) {
    for (int i = 0; i < 8; ++i) {
      const Vec3 signs(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
      const Vec3 p = to_viewer * (box.centre + box.R * box.size.cwiseProduct(signs) / 2);
      corners_[static_cast<std::size_t>(i)] = {at.x + at.scale * p.x(), at.y - at.scale * p.y(),
                                               at.scale * p.z()};
      if (p.z() < corners_[static_cast<std::size_t>(farthest_)].z() / at.scale) farthest_ = i;
    }
  }

  std::string behind(const std::string& look) const { return path(true, look); }
  std::string in_front(const std::string& look) const { return path(false, look); }

 private:
  std::string path(bool behind, const std::string& look) const {
    std::string d;
    for (int i = 0; i < 8; ++i)
      for (const int bit : {1, 2, 4}) {
        const int j = i | bit;
        if (i == j || (i == farthest_ || j == farthest_) != behind) continue;
        d += "M" + point(i) + "L" + point(j);
      }
    return "<path fill=\"none\" " + look + " d=\"" + d + "\"/>\n";
  }
  std::string point(int i) const {
    const Vec3& p = corners_[static_cast<std::size_t>(i)];
    return svg_number(p.x()) + " " + svg_number(p.y());
  }

  std::array<Vec3, 8> corners_;
  int farthest_ = 0;
};

}  // namespace

Table equivalent_table() {
  Table table({"object", "box around it", "box with its inertia", "volumes, to the object's"});
  for (const Thing& body : things()) {
    const boxes::OrientedBox around = boxes::aligned_box(body.points()),
                             same = equivalent_box(body.truth);
    const auto sorted = [](Vec3 size) {
      std::sort(size.begin(), size.end(), std::greater<>());
      return millimetres(size);
    };
    table.add(
        {body.name, sorted(around.size), sorted(same.size),
         times(around.volume() / body.volume()) + ", " + times(same.volume() / body.volume())});
  }
  return table;
}

std::string equivalent_figure() {
  std::string svg =
      support::svg_open(760, 330, "The box around a body and the box that turns like it");
  const auto draw = [&](const Thing& body, const Mat3& R, double x, double scale) {
    const boxes::OrientedBox around = boxes::aligned_box(body.points());
    const Vec3 middle = R * around.centre;
    const support::Placement at{x - scale * middle.x(), 150 + scale * middle.y(), scale};
    const BoxLines outer(around, R, at), inner(equivalent_box(body.truth), R, at);
    const std::string blue = support::stroke_of("c0") + " stroke-width=\"1.6\"",
                      orange = support::stroke_of("c1") + " stroke-width=\"2.2\"";
    svg += outer.behind(blue + " opacity=\"0.6\"") + support::draw_mesh(body.mesh, R, at);
    svg += inner.behind(orange + " stroke-dasharray=\"4 4\"") + inner.in_front(orange);
    svg += outer.in_front(blue);
    svg += "<text x=\"" + svg_number(x) + "\" y=\"316\" " + support::fill_of("ink") +
           " font-size=\"20\" " + "text-anchor=\"middle\">" + body.name + "</text>\n";
  };
  draw(t_handle(), axis_rotation(0, -0.75) * axis_rotation(2, -0.5), 200, 2250);
  draw(wing_nut(), axis_rotation(0, 0.4) * axis_rotation(0, -pi / 2) * axis_rotation(2, -0.45), 565,
       6000);
  return svg + "</svg>\n";
}

}  // namespace bounding_boxes_chapter
