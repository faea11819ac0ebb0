/// @file
/// A T-handle that turns over: in the world, on the sphere of L, and its spins over time.

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "09_rigid_body/laws.hpp"
#include "09_rigid_body/moving_figures.hpp"
#include "09_rigid_body/polhodes.hpp"
#include "objects/t_handle.hpp"
#include "support/space_sketch.hpp"
#include "support/view.hpp"
#include "tumble/mass/mirtich/mirtich.hpp"
#include "tumble/ode/rk4.hpp"

namespace rigid_body_chapter::handle_figure {

namespace {

using support::Control;
using support::Drag;
using support::Settings;

constexpr double pi = std::numbers::pi, degree = pi / 180;
constexpr double longest = 20, spacing = 0.02;  // of what is shown, of its samples [s]
constexpr int samples = 1000;

enum Which { time, aim, law, around, above };
constexpr std::array<Control, 5> controls{
    {{"t", "time", "s", 0, longest, spacing, 1.2},
     {"aim", "aimed to 10⁻ᵏ rad, k", "", 0.5, 6, 0.1, 2},
     {"law", "law of motion", "", 0, 2, 1, 0, "the right one|rotating term left out|put in twice"},
     {"around", "you stand at", "°", -180, 180, 1, 30},
     {"above", "above the floor by", "°", -80, 80, 1, 20}}};
/// The laws of the control, among all.
constexpr std::array<std::size_t, 3> offered{0, 2, 3};

/// The handle: its mesh about its centre of mass, and its mass properties.
struct Handle {
  PolygonMesh mesh;
  RigidBody<> body;
  PrincipalAxes axes;
};

const Handle& the_handle() {
  static const Handle made = [] {
    PolygonMesh mesh = objects::t_handle(1);
    const MassProperties mass = tumble::detail::unchecked_mirtich(mesh, 2700);
    for (Vec3& v : mesh.vertices) v -= mass.centre;
    const RigidBody<> body(mass);
    return Handle{mesh, body, principal_axes(body.I_body())};
  }();
  return made;
}

/// One turn per second about the middle axis, which points up, and off by `tilt` [rad].
RigidBodyState<> start_of(double tilt) {
  Mat3 up;  // the least axis along x, the middle one along z
  up << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  const Quat q = from_matrix(Mat3(up * the_handle().axes.R.transpose()));
  const Vec3 omega = 2 * pi * (up * Vec3(tilt, 1, -tilt));
  return state_of_motion<double>(the_handle().body, Vec3::Zero(), q, Vec3::Zero(), omega);
}

/// The handle at one time.
struct Sample {
  Quat q;      ///< body → world
  Vec3 L;      ///< in the world
  Vec3 omega;  ///< along the axes of the least, the middle and the largest moment [rad/s]
};

Sample sample(const Quat& q, const Vec3& L) {
  const Vec3 L_body = the_handle().axes.R.transpose() * (to_matrix(q).transpose() * L);
  return {q, L, L_body.cwiseQuotient(the_handle().axes.moments)};
}

std::vector<Sample> in_closed_form(const RigidBodyState<>& start) {
  const FreeTrajectory motion(the_handle().body, start);
  std::vector<Sample> all;
  for (int i = 0; i <= samples; ++i) all.push_back(sample(motion.at(i * spacing).q, start.L));
  return all;
}

std::vector<Sample> by_steps(const Law& law, const RigidBodyState<>& start) {
  constexpr int steps = 4;  // per sample
  const RigidBody<>& body = the_handle().body;
  const auto rate = [&](double, const Seven& y) { return law.rate(body, y); };
  const Vec3 omega = derived(body, start).omega;
  Seven y = seven(start.q, law.of_L ? start.L : to_matrix(start.q).transpose() * omega);
  std::vector<Sample> all;
  for (int i = 0; i <= samples; ++i) {
    const Quat q = orientation_in(y).normalized();
    const Vec3 last = y.tail<3>();
    all.push_back(sample(q, law.of_L ? last : to_matrix(q) * (body.I_body() * last)));
    for (int k = 0; k < steps; ++k) y = Rk4::step(rate, 0., y, spacing / steps);
  }
  return all;
}

/// What another's functions gave, or nothing.
std::vector<Sample>& given_motion() {
  static std::vector<Sample> all;
  return all;
}

/// The motion by the settings; it is computed again when they change.
const std::vector<Sample>& motion_of(Settings now) {
  if (!given_motion().empty()) return given_motion();
  static std::vector<Sample> all;
  static double last_aim = -1, last_law = -1;
  if (now[aim] == last_aim && now[law] == last_law) return all;
  last_aim = now[aim];
  last_law = now[law];
  const RigidBodyState<> start = start_of(std::pow(10., -now[aim]));
  const Law& chosen = laws[offered[static_cast<std::size_t>(now[law])]];
  all = chosen.rate == L_stays ? in_closed_form(start) : by_steps(chosen, start);
  return all;
}

void draw_in_the_world(support::Sketch& sketch, const Sample& now, const Mat3& view) {
  constexpr double x = 190, y = 190, scale = 1750;
  sketch.drawing(support::draw_mesh(the_handle().mesh, view * to_matrix(now.q), {x, y, scale}));
  sketch.look({x, y, 150});
  support::SpaceSketch space(sketch, view);
  const Vec3 L = now.L.normalized();
  space.arrow(Vec3::Zero(), L, {"ink", 2});
  space.words(L, {0, -8}, "L");
}

/// The tip of L in the body, as a part of its length at the start.
Vec3 tip_of(const Sample& now, const Sample& start) {
  return now.omega.cwiseProduct(the_handle().axes.moments) / start.L.norm();
}

void draw_on_the_sphere(support::Sketch& sketch, const std::vector<Sample>& all, std::size_t i) {
  constexpr std::size_t trail = 150;
  sketch.look({570, 190, 172});
  draw_sphere(sketch, the_handle().axes.moments, "the tip of L in the body");
  Way way{{}, {"ink", 2.6}};
  for (std::size_t k = i < trail ? 0 : i - trail; k <= i; ++k)
    way.points.push_back(tip_of(all[k], all[0]));
  for (const bool near : {false, true})
    sketch.curves(visible(way, sphere_view(), near), {"ink", near ? 2.6 : 1.4, near ? 1 : 0.4});
  const Vec3 tip = sphere_view() * way.points.back();
  sketch.dot(tip.head<2>(), "c6", tip.z() > 0 ? 6 : 3);  // smaller where it is behind the sphere
}

void draw_spins(support::Sketch& sketch, const std::vector<Sample>& all, std::size_t i) {
  constexpr double left = 20, middle = 510, width = 640, height = 62;
  const auto at = [&](std::size_t k, double omega) -> Vec2 {
    return {static_cast<double>(k) * width / samples, omega / (2 * pi) * height};
  };
  sketch.look({left, middle, 1});
  sketch.curve({at(0, 0), at(samples, 0)}, {"faint", 1});
  const std::array<std::string, 3> names{"least", "middle", "largest"}, colours{"c0", "c1", "c2"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<Vec2> curve;
    for (std::size_t k = 0; k <= samples; k += 2)
      curve.push_back(at(k, all[k].omega[static_cast<Eigen::Index>(axis)]));
    sketch.curve(curve, {colours[axis], 1.6});
    sketch.words({width, 0}, {10, 6 + 24 * (static_cast<double>(axis) - 1)}, names[axis],
                 colours[axis]);
  }
  sketch.curve({at(i, -8), at(i, 8)}, {"ink", 1.2});
  sketch.words({0, -96}, {0, 0}, "turns per second about its own axes, for 20 seconds");
}

std::string draw(Settings now) {
  const std::vector<Sample>& all = motion_of(now);
  const auto i = static_cast<std::size_t>(std::lround(now[time] / spacing));
  support::Sketch sketch(760, 620, "A T-handle that turns over, and the tip of L in it", 17);
  draw_in_the_world(sketch, all[i], support::view_from(now[around] * degree, now[above] * degree));
  draw_on_the_sphere(sketch, all, i);
  draw_spins(sketch, all, i);
  return sketch.svg();
}

void drag(std::span<double> settings, const Drag& pointer) {
  constexpr double per_pixel = 0.5;
  double turned = settings[around] - per_pixel * pointer.dx;
  if (turned > 180) turned -= 360;
  if (turned < -180) turned += 360;
  settings[around] = allowed(controls[around], turned);
  settings[above] = allowed(controls[above], settings[above] + per_pixel * pointer.dy);
}

// ── By another's functions ──

std::vector<double> question(Settings now) {
  constexpr int steps_a_sample = 4;
  const RigidBody<>& body = the_handle().body;
  const RigidBodyState<> start = start_of(std::pow(10., -now[aim]));
  const Mat3& I = body.I_body();
  std::vector<double> all{body.mass()};
  all.insert(all.end(), I.data(), I.data() + I.size());  // symmetric: its columns are its rows
  all.insert(all.end(), {start.x.x(), start.x.y(), start.x.z(), start.q.w(), start.q.x(),
                         start.q.y(), start.q.z(), start.P.x(), start.P.y(), start.P.z(),
                         start.L.x(), start.L.y(), start.L.z()});
  all.insert(all.end(), {longest, steps_a_sample * samples, samples});
  return all;
}

void take(std::span<const double> states) {
  constexpr std::size_t numbers_a_state = 13;
  given_motion().clear();
  for (std::size_t i = 0; i + numbers_a_state <= states.size(); i += numbers_a_state) {
    const double* y = states.data() + i;
    given_motion().push_back(
        sample(Quat(y[3], y[4], y[5], y[6]).normalized(), Vec3(y[10], y[11], y[12])));
  }
}

constexpr support::GivenMotion by_others{question, take};

}  // namespace
}  // namespace rigid_body_chapter::handle_figure

const tumble::support::MovingFigure tumble::figures::handle{
    "handle",
    rigid_body_chapter::handle_figure::controls,
    rigid_body_chapter::handle_figure::draw,
    rigid_body_chapter::handle_figure::drag,
    rigid_body_chapter::handle_figure::time,
    &rigid_body_chapter::handle_figure::by_others};
