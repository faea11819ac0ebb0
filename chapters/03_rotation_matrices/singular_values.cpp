/// @file
/// The singular value decomposition in one picture: sphere, ellipsoid, sphere.

#include "common.hpp"
#include "parts.hpp"

namespace rotation_matrices_chapter {

namespace {

using support::Pen, support::Sketch, support::SpaceSketch, support::Vec2;

/// What a matrix has made of the unit sphere and of three arrows in it.
struct Image {
  Mat3 shape;  // its columns are the half axes, each the image of one arrow
  double x;    // [px] where its middle is drawn
  std::string below, names;
};

std::string subscript(std::size_t i) { return std::array<std::string, 3>{"₁", "₂", "₃"}[i]; }

/// The outline of an ellipsoid: the image of the circle of the sphere that the viewer sees as its
/// edge.
std::vector<Vec3> outline(const Mat3& shape, const Mat3& view) {
  const Vec3 toward = (shape.inverse() * view.row(2).transpose());
  // A point M n of the surface is on the outline if its normal M⁻ᵀ n is perpendicular to the view.
  const Vec3 pole = toward.normalized();
  const Vec3 start = pole.unitOrthogonal();
  std::vector<Vec3> points;
  for (const Vec3& n : support::arc(Vec3::Zero(), start, pole, 2 * std::numbers::pi))
    points.emplace_back(shape * n);
  return points;
}

void draw_image(Sketch& sketch, const Mat3& view, const Image& image) {
  sketch.look({image.x, 150, 78});
  SpaceSketch space(sketch, view);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<Vec3> ring;
    for (const Vec3& n : support::arc(Vec3::Zero(), Vec3::Unit((axis + 1) % 3), Vec3::Unit(axis),
                                      2 * std::numbers::pi))
      ring.emplace_back(image.shape * n);
    space.curve(ring, {"faint", 1, 0.7});
  }
  space.curve(outline(image.shape, view), {"faint", 1.8});
  const std::array<const char*, 3> colours{"c0", "c1", "c2"};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 tip = image.shape.col(static_cast<Eigen::Index>(i));
    space.arrow(Vec3::Zero(), tip, {colours[i], 2.6});
    space.name_at_tip(
        Vec3::Zero(), 1.06 * tip,
        image.names + subscript(i) + (image.names == "σ" ? " u" + subscript(i) : std::string()),
        colours[i]);
  }
  sketch.words({0, 0}, {0, 150}, image.below, "ink", "middle");
}

void draw_step(Sketch& sketch, double x, const std::string& above) {
  sketch.look({x, 150, 1});
  sketch.arrow({-22, 0}, {22, 0}, {"ink", 2});
  sketch.words({0, 0}, {0, -12}, above, "ink", "middle");
}

}  // namespace

std::string ellipsoid_figure() {
  Sketch sketch(760, 352, "A matrix makes an ellipsoid of the unit sphere", 17);
  const Mat3 view = front_view();
  Mat3 seen;  // three arrows that all point a little towards the viewer
  seen << Vec3(-1, -1 / std::sqrt(3.), std::sqrt(2. / 3)),
      Vec3(1, -1 / std::sqrt(3.), std::sqrt(2. / 3)), Vec3(0, 2 / std::sqrt(3.), std::sqrt(2. / 3));
  seen /= std::sqrt(2.);
  const Mat3 V = view.transpose() * seen;
  const Mat3 U = view.transpose() * exp_rotation(Vec3(0.2, 0.15, 0.75)) * seen;
  const Vec3 sigma(1.4, 0.95, 0.7);
  draw_image(sketch, view, {V, 115, "the unit sphere", "v"});
  draw_image(sketch, view, {U * sigma.asDiagonal(), 385, "what M makes of it", "σ"});
  draw_image(sketch, view, {U, 650, "each σ made 1", "u"});
  draw_step(sketch, 240, "M");
  draw_step(sketch, 532, "÷ σ");
  sketch.look({0, 0, 1});
  sketch.curve({{115, -314}, {115, -322}, {650, -322}}, {"c3", 2});
  sketch.arrow({650, -322}, {650, -311}, {"c3", 2});
  sketch.words({382, -322}, {0, 22}, "both at once: R = U Vᵀ", "c3", "middle");
  return sketch.svg();
}

}  // namespace rotation_matrices_chapter
