/// @file
/// Objects that are thrown with their own inertia, and with that of a box.

#include "common.hpp"
#include "parts.hpp"
#include "support/flipbook.hpp"
#include "support/plot.hpp"
#include "tumble/body.hpp"
#include "tumble/ode.hpp"
#include "tumble/quaternion.hpp"

namespace bounding_boxes_chapter {

namespace {

/// How a body is turned after a free flight.
/// @param omega at the start, in body axes, which are the world's then [rad/s]
Mat3 flown(const Mat3& I_body, const Vec3& omega, double duration) {
  if (duration == 0) return Mat3::Identity();
  const RigidBody<> body(1, I_body);
  const RigidBodyRhs motion(body);
  const auto start =
      state_of_motion<double>(body, Vec3::Zero(), Quat::Identity(), Vec3::Zero(), omega);
  const auto end = integrate_adaptive<Dop853>(motion, pack(start), 0.0, duration, {1e-12, 1e-12});
  return derived(body, unpack<double>(end.y)).R;
}

double angle_apart(const Mat3& A, const Mat3& B) {
  return log_rotation(Mat3(A.transpose() * B)).norm();
}

// ── All objects ──

std::string whole_degrees(double angle) { return svg_number(angle / degree, 0) + "°"; }

/// How far the orientation is off after one second, the mean of 16 throws.
/// @param inertia inertia(i) is what throw i takes for the body's inertia
template <class Inertia>
double off_after_a_second(const Thing& body, const Inertia& inertia) {
  constexpr int throws = 16;
  Random random(7);
  double sum = 0;
  for (std::size_t i = 0; i < throws; ++i) {
    const Vec3 omega = 10 * random.vector(1).normalized();
    sum += angle_apart(flown(body.truth.inertia, omega, 1), flown(inertia(i), omega, 1));
  }
  return sum / throws;
}

std::string ratio_text(const Mat3& I) {
  const Vec3 moments = principal_axes(I).moments;
  return svg_number(moments[0] / moments[2], 3) + " : " + svg_number(moments[1] / moments[2], 3) +
         " : 1";
}

/// The axes from the easiest to the hardest: z < x < y.
std::string order_text(const Mat3& I) {
  std::array<int, 3> axes{0, 1, 2};
  const auto equal = [&I](int a, int b) { return std::abs(I(a, a) - I(b, b)) < 1e-9 * I.trace(); };
  std::sort(axes.begin(), axes.end(),
            [&](int a, int b) { return equal(a, b) ? a < b : I(a, a) < I(b, b); });
  std::string text(1, "xyz"[axes[0]]);
  for (const std::size_t i : {1u, 2u})
    text += (equal(axes[i - 1], axes[i]) ? " = " : " < ") + std::string(1, "xyz"[axes[i]]);
  return text;
}

}  // namespace

Table flight_table() {
  Table table({"object", "upright", "askew", "principal", "smaller", "a ball"});
  for (const Thing& body : things()) {
    const auto off = [&](const boxes::OrientedBox& box) {
      const Mat3 I = at_true_mass(box, body).inertia;
      return whole_degrees(off_after_a_second(body, [&I](std::size_t) { return I; }));
    };
    const double askew = off_after_a_second(body, [&body](std::size_t i) {
      return at_true_mass(askew_box(body.points(), turns()[i]), body).inertia;
    });
    const double ball =
        off_after_a_second(body, [](std::size_t) -> Mat3 { return Mat3::Identity(); });
    table.add({body.name, off(boxes::aligned_box(body.points())), whole_degrees(askew),
               off(boxes::principal_box(body.points())),
               off(boxes::small_oriented_box(body.points())), whole_degrees(ball)});
  }
  return table;
}

std::string rule_figure() {
  support::Plot plot{"one second at 10 rad/s",
                     {"difference of the tensors, as shapes", support::Scale::log},
                     {"off by [°]", support::Scale::log},
                     {}};
  support::Series line{"difference × 10 rad", {0.008, 0.3}, {}};
  for (const double x : line.x) line.y.push_back(10 * x / degree);
  plot.series.push_back(line);
  const auto add = [&](const std::string& name, const auto& inertias) {
    support::Series dots{name, {}, {}, support::Look::dots};
    for (const Thing& body : things())
      for (const Mat3& I : inertias(body)) {
        dots.x.push_back(shape_difference(body.truth.inertia, I));
        dots.y.push_back(off_after_a_second(body, [&I](std::size_t) { return I; }) / degree);
      }
    plot.series.push_back(dots);
  };
  using List = std::vector<Mat3>;
  add("a ball", [](const Thing&) { return List{Mat3::Identity()}; });
  add("askew", [](const Thing& body) {
    List list;
    for (std::size_t i = 0; i < 4; ++i)
      list.push_back(at_true_mass(askew_box(body.points(), turns()[i]), body).inertia);
    return list;
  });
  add("smaller", [](const Thing& body) {
    return List{at_true_mass(boxes::small_oriented_box(body.points()), body).inertia};
  });
  add("upright", [](const Thing& body) {
    return List{at_true_mass(boxes::aligned_box(body.points()), body).inertia};
  });
  return support::to_svg(plot);
}

Table moments_table() {
  Table table({"object", "easy to hard", "ratio", "its box", "ratio", "difference"});
  for (const Thing& body : things()) {
    const Mat3 box = at_true_mass(boxes::aligned_box(body.points()), body).inertia;
    table.add({body.name, order_text(body.truth.inertia), ratio_text(body.truth.inertia),
               order_text(box), ratio_text(box),
               svg_number(shape_difference(body.truth.inertia, box), 3)});
  }
  return table;
}

// ── The mug ──

namespace {

/// Spun about the axis about which it is easiest to turn, three turns a second.
Vec3 mug_spin() {
  const Vec3 axis = principal_axes(mug().truth.inertia).R.col(0);
  return 6 * pi * (axis.z() < 0 ? Vec3(-axis) : axis);
}
Mat3 mug_box_inertia() { return at_true_mass(boxes::aligned_box(mug().points()), mug()).inertia; }

/// How far the axis of the spin, painted on the mug, has gone from where it was.
double leaned(const Mat3& R) {
  const Vec3 axis = mug_spin().normalized();
  return std::acos(std::min(1.0, axis.dot(R * axis)));
}

/// World to viewer for the mug: the spin's axis upright, seen from a little above.
Mat3 mug_viewer() {
  const Vec3 up = mug_spin().normalized();
  const Vec3 side = Vec3::UnitY(), front = side.cross(up).normalized();
  Mat3 to_upright;  // its rows: right, up, towards the viewer
  to_upright << front.transpose(), up.transpose(), front.cross(up).transpose();
  return axis_rotation(0, 0.3) * to_upright;
}

/// A mug as few lines, the middle of its box as the origin.
class MugLines {
 public:
  explicit MugLines(const Mat3& to_viewer) : R_(to_viewer) {}

  void draw(support::Sketch& sketch) const {
    const bool handle_behind = (R_ * Vec3::UnitX()).z() < 0;
    if (handle_behind) draw_handle(sketch);
    draw_wall(sketch);
    const bool from_above = (R_ * Vec3::UnitZ()).z() > 0;
    if (from_above) {
      sketch.curve(ring(top, 1), {"ink", 1.4, 1, 1});
      sketch.curve(ring(top, 0.9), {"grid", 1.2, 1, 1});
    } else {
      sketch.curve(ring(bottom, 1), {"faint", 1.4, 1, 1});
    }
    if (!handle_behind) draw_handle(sketch);
  }

 private:
  static constexpr double radius = 0.041, bottom = -0.048, top = 0.048, shift = -0.0167;  // [m]

  Vec2 seen(const Vec3& p) const { return (R_ * p).head<2>(); }

  std::vector<Vec2> ring(double z, double size) const {
    std::vector<Vec2> points;
    for (int i = 0; i <= 32; ++i) {
      const double angle = 2 * pi * i / 32;
      points.push_back(
          seen({shift + size * radius * std::cos(angle), size * radius * std::sin(angle), z}));
    }
    return points;
  }

  void draw_wall(support::Sketch& sketch) const {
    const bool from_above = (R_ * Vec3::UnitZ()).z() > 0;
    std::vector<Vec2> outline = half_ring(from_above ? bottom : top, 0);
    const std::vector<Vec2> other = half_ring(from_above ? top : bottom, pi);
    outline.insert(outline.end(), other.begin(), other.end());
    outline.push_back(outline.front());
    sketch.curve(outline, {"solid", 1, 1, 1});
    sketch.curve(outline, {"ink", 1.4});
  }

  /// The half of a ring that is nearer to the viewer, or half a turn away from it.
  std::vector<Vec2> half_ring(double z, double away) const {
    const Vec3 towards = R_.transpose() * Vec3::UnitZ();
    const double middle = std::atan2(towards.y(), towards.x()) + away;
    std::vector<Vec2> points;
    for (int i = 0; i <= 16; ++i) {
      const double angle = middle + pi * (i / 16.0 - 0.5);
      points.push_back(seen({shift + radius * std::cos(angle), radius * std::sin(angle), z}));
    }
    return points;
  }

  void draw_handle(support::Sketch& sketch) const {
    std::vector<Vec2> points;
    for (int i = 0; i <= 16; ++i) {
      const double angle = pi * i / 16;
      points.push_back(
          seen({shift + radius + 0.030 * std::sin(angle), 0, 0.007 + 0.025 * std::cos(angle)}));
    }
    sketch.curve(points, {"ink", 8});
    sketch.curve(points, {"c1", 5.5});
  }

  Mat3 R_;
};

}  // namespace

Table mug_table() {
  Table table({"after", "the mug's own inertia", "its box", "mug and box apart"});
  for (const double t : {0.25, 0.5, 0.75, 1.0, 1.25, 1.5}) {
    const Mat3 own = flown(mug().truth.inertia, mug_spin(), t);
    const Mat3 box = flown(mug_box_inertia(), mug_spin(), t);
    const auto tilt = [](double angle) {
      return angle < 1e-5 ? std::string("0°") : support::degrees(angle, 3);
    };
    table.add({number(t) + " s", tilt(leaned(own)), tilt(leaned(box)),
               support::degrees(angle_apart(own, box), 3)});
  }
  return table;
}

namespace {

/// The mug after a time in flight, with the axis of its spin painted on it.
void draw_flown_mug(support::Sketch& sketch, const Mat3& I, double t, const std::string& colour) {
  const Mat3 R = flown(I, mug_spin(), t);
  const Vec2 tip = (mug_viewer() * R * mug_spin().normalized()).head<2>();
  MugLines(mug_viewer() * R).draw(sketch);
  sketch.arrow(0.06 * tip, 0.098 * tip, {colour, 2.6});
}

/// One throw, computed with each of two tensors.
struct Throw {
  Mat3 I;
  std::string colour, caption;
};

std::array<Throw, 2> both_throws() {
  return {{{mug().truth.inertia, "c0", "with its own inertia tensor"},
           {mug_box_inertia(), "c6", "with that of its bounding box"}}};
}

}  // namespace

std::string spin_figure() {
  constexpr int pictures = 6;
  support::Sketch sketch(760, 432, "A mug that spins, with its own inertia and with its box's", 20);
  double y = 96;
  for (const Throw& each : both_throws()) {
    sketch.look({380, y, 800});
    sketch.words({0, 0}, {0, 92}, each.caption, each.colour, "middle");
    for (int i = 0; i < pictures; ++i) {
      const double t = 0.25 * i;
      sketch.look({760 * (i + 0.5) / pictures, y, 800});
      draw_flown_mug(sketch, each.I, t, each.colour);
    }
    y += 208;
  }
  for (int i = 0; i < pictures; ++i) {
    sketch.look({760 * (i + 0.5) / pictures, 422, 800});
    sketch.words({0, 0}, {0, 0}, number(0.25 * i) + " s", "ink", "middle");
  }
  return sketch.svg();
}

std::string slow_motion_figure() {
  constexpr double duration = 1.5, slower = 4;
  constexpr int pictures = 54;  // 12 a turn
  support::Sketch sketch(760, 320, "The mug in slow motion, with its own inertia and its box's",
                         20);
  const std::array<Throw, 2> throws = both_throws();
  const auto look = [&sketch](std::size_t i) {
    sketch.look({190 + 380 * static_cast<double>(i), 140, 1300});
  };
  for (std::size_t i = 0; i < throws.size(); ++i) {
    look(i);
    sketch.words({0, 0}, {0, 170}, throws[i].caption, throws[i].colour, "middle");
  }
  support::flipbook(sketch, pictures, slower * duration, [&](int k) {
    for (std::size_t i = 0; i < throws.size(); ++i) {
      look(i);
      draw_flown_mug(sketch, throws[i].I, duration * k / pictures, throws[i].colour);
    }
  });
  return sketch.svg();
}

}  // namespace bounding_boxes_chapter
