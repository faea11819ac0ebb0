/// @file
/// Figure 3.9: a mug, one of whose axes the reader pulls, and what each repair makes of it.

#include <array>
#include <cmath>
#include <string>

#include "03_rotation_matrices/conditions.hpp"
#include "03_rotation_matrices/favourite.hpp"
#include "03_rotation_matrices/moving_figures.hpp"
#include "03_rotation_matrices/paper_rotation.hpp"
#include "objects/plain_mug.hpp"
#include "support/facets.hpp"
#include "tumble/rotation/nearest_rotation.hpp"
#include "tumble/rotation/newton_rotation.hpp"
#include "tumble/rotation/orthonormality.hpp"

namespace rotation_matrices_chapter::pulled_figure {

namespace {

using support::Control;
using support::Drag;
using support::Settings;
using support::Sketch;
using support::SpaceSketch;
using support::svg_number;
using support::Vec2;

enum Which { arrow, by_x, by_y, by_z, repair };
constexpr std::array<Control, 5> controls{
    {{"arrow", "you pull", "", 0, 2, 1, 1, "x|y|z"},
     {"x", "along world x by", "", -1, 0.8, 0.01, 0.16},
     {"y", "along world y by", "", -1, 0.8, 0.01, 0.43},
     {"z", "along world z by", "", -1, 0.8, 0.01, 0.18},
     {"repair", "repair", "", 0, 5, 1, 5,
      "Gram–Schmidt, x first|Gram–Schmidt, y first|Gram–Schmidt, z first|one Newton step|two "
      "Newton "
      "steps|nearest rotation"}}};

/// In the order of the control.
struct Repair {
  const char* name;
  Mat3 (*apply)(const Mat3&);
};
constexpr std::array<Repair, 6> repairs{
    {{"Gram–Schmidt, x first", [](const Mat3& M) { return gram_schmidt_from(M, 0); }},
     {"Gram–Schmidt, y first", [](const Mat3& M) { return gram_schmidt_from(M, 1); }},
     {"Gram–Schmidt, z first", [](const Mat3& M) { return gram_schmidt_from(M, 2); }},
     {"one Newton step", [](const Mat3& M) { return rotation::newton_rotation_step(M); }},
     {"two Newton steps",
      [](const Mat3& M) {
        return rotation::newton_rotation_step(rotation::newton_rotation_step(M));
      }},
     {"the nearest rotation", [](const Mat3& M) { return nearest_rotation(M); }}}};

/// The rotation that was there, with one column pulled away.
Mat3 pulled_matrix(Settings now) {
  Mat3 M = paper_rotation();
  M.col(static_cast<Eigen::Index>(now[arrow])) += Vec3(now[by_x], now[by_y], now[by_z]);
  return M;
}

/// Where no volume is left, or a mirrored one, there is nothing to repair.
constexpr double flat = 1e-3;

const Mat3& view() {
  static const Mat3 from_the_front = support::view_from(-8 * degree, 18 * degree);
  return from_the_front;
}

// ── The mug ──

constexpr double mug_scale = 1150, arrow_length = 0.087;  // [px/m], [m] of a column of length 1
constexpr double out_of_the_picture = 5;                  // ‖M‖
constexpr double middle_y = 225, left_x = 185, right_x = 565;

support::Window window(double x) { return {x, middle_y, mug_scale * arrow_length}; }

void draw_mug(Sketch& sketch, const Mat3& M, double x) {
  static const PolygonMesh mug = objects::plain_mug();
  if (M.determinant() < flat || M.norm() > out_of_the_picture) return;
  const Vec3 middle = view() * M * Vec3(0, 0, 0.0475);
  sketch.drawing(support::draw_pale_facets(
      mug, view() * M, {x - mug_scale * middle.x(), middle_y + mug_scale * middle.y(), mug_scale}));
}

/// What the repair was given, behind what it made.
void draw_ghost(Sketch& sketch, const Mat3& M) {
  sketch.look(window(right_x));
  SpaceSketch space(sketch, view());
  for (Eigen::Index j = 0; j < 3; ++j) space.arrow(Vec3::Zero(), M.col(j), {"faint", 1.6});
}

void draw_arrows(Sketch& sketch, const Mat3& M, double x) {
  sketch.look(window(x));
  SpaceSketch(sketch, view()).axes(Vec3::Zero(), M, {"x", "y", "z"}, column_pens);
}

// ── The numbers ──

void draw_numbers(Sketch& sketch, const Mat3& M, const std::string& name, double x) {
  draw_matrix(sketch, M, name, {x - 83, 405, 66, 28});
  sketch.look({0, 0, 1});
  draw_conditions(sketch, M, x - 126, 478);
  const auto line = [&](double y, const std::string& text) {
    sketch.words({x, -y}, {0, 0}, text, "ink", "middle");
  };
  const std::string transposed = name == "M" ? "‖MᵀM − 1‖ = " : "‖RᵀR − 1‖ = ";
  line(530, transposed + small_number(rotation::orthonormality_error(M)));
  line(554, "det " + name + " = " + svg_number(M.determinant(), 3));
}

void draw_repaired(Sketch& sketch, const Mat3& M, const Repair& chosen) {
  const auto words = [&](double y, const std::string& text, const std::string& colour) {
    sketch.look({0, 0, 1});
    sketch.words({right_x, -y}, {0, 0}, text, colour, "middle");
  };
  words(24, chosen.name, "ink");
  if (M.determinant() < flat) {
    draw_ghost(sketch, M);
    words(405, M.determinant() < 0 ? "det M < 0: a mirrored mug." : "det M = 0: a flat mug.", "c6");
    return words(429, "No repair knows which axis is to blame.", "c6");
  }
  const Mat3 R = chosen.apply(M);
  if (R.norm() > out_of_the_picture) words(330, "The step went too far to be drawn.", "c6");
  draw_mug(sketch, R, right_x);
  draw_ghost(sketch, M);
  draw_arrows(sketch, R, right_x);
  draw_numbers(sketch, R, "R", right_x);
  words(578, "moved by ‖R − M‖ = " + svg_number((R - M).norm(), 3), "ink");
  words(602, turned_by(M, R), "ink");
}

std::string draw(Settings now) {
  Sketch sketch(760, 616, "A mug whose axes are pulled, and the same mug repaired", 17);
  const Mat3 M = pulled_matrix(now);
  sketch.words({left_x, -24}, {0, 0}, "pull an arrow by its tip", "ink", "middle");
  draw_mug(sketch, M, left_x);
  draw_arrows(sketch, M, left_x);
  SpaceSketch space(sketch, view());
  for (Eigen::Index j = 0; j < 3; ++j)
    space.dot(M.col(j), column_pens[static_cast<std::size_t>(j)].colour, 6);
  for (Eigen::Index j = 0; j < 3; ++j) sketch.grip({space.seen(M.col(j))});
  sketch.look({45, 290, 1});
  SpaceSketch(sketch, view()).world_axes(Vec3::Zero(), 36);
  draw_numbers(sketch, M, "M", left_x);
  draw_repaired(sketch, M, repairs[static_cast<std::size_t>(now[repair])]);
  return sketch.svg();
}

/// The column whose tip is nearest to a point of the picture's plane.
Eigen::Index nearest_tip(const Mat3& M, const Vec2& point) {
  Eigen::Index nearest = 0;
  const Eigen::Matrix<double, 1, 3> squares =
      ((view() * M).topRows<2>().colwise() - point).colwise().squaredNorm();
  squares.minCoeff(&nearest);
  return nearest;
}

/// Takes the tip with the pointer, in the plane of the picture. An arrow that was pulled before
/// goes back, so you see what each of them does.
void drag(std::span<double> settings, const Drag& pointer) {
  const support::Window left = window(left_x);
  const Vec2 at((pointer.x - left.x) / left.scale, (left.y - pointer.y) / left.scale);
  if (pointer.begins())
    settings[arrow] = static_cast<double>(nearest_tip(pulled_matrix(settings), at));
  const Vec2 from =
      (view() * paper_rotation().col(static_cast<Eigen::Index>(settings[arrow]))).head<2>();
  const Vec3 by = view().transpose() * Vec3(at.x() - from.x(), at.y() - from.y(), 0);
  for (const Which axis : {by_x, by_y, by_z})
    settings[axis] = allowed(controls[axis], by[axis - by_x]);
}

}  // namespace
}  // namespace rotation_matrices_chapter::pulled_figure

const tumble::support::MovingFigure tumble::figures::pulled{
    "pulled", rotation_matrices_chapter::pulled_figure::controls,
    rotation_matrices_chapter::pulled_figure::draw, rotation_matrices_chapter::pulled_figure::drag};
