/// @file
/// The free body with three moments: elliptic functions, the way of L against the clock, and the
/// error far in the future.

#include "common.hpp"
#include "parts.hpp"
#include "reference/polhode_round.hpp"
#include "tumble/elliptic/complementary_theta_series.hpp"
#include "tumble/elliptic/theta_series.hpp"

namespace scene_chapter {

// ── Elliptic sines ──

namespace {

/// sn for k'² = 1 − k², over one period and a little more: the curves part again there, and none of
/// them is at the last line of the grid yet.
support::Series elliptic_sine(const std::string& name, double kc2) {
  const elliptic::Modulus modulus{1 - kc2, kc2};
  const elliptic::Amplitude eta{0, 1};
  const double K = elliptic::complete_elliptic_k(std::sqrt(kc2));
  const auto sn = [&](double u) {
    return modulus.k2 < modulus.kc2 ? elliptic::ThetaSeries(modulus, eta)(u).sn
                                    : elliptic::ComplementaryThetaSeries(modulus, eta)(u).sn;
  };
  support::Series series{name, {}, {}};
  for (int i = 0; i <= 491; ++i) {
    const double turns = i / 480.0;
    series.x.push_back(turns);
    series.y.push_back(sn(4 * K * turns));
  }
  return series;
}

}  // namespace

std::string sn_figure() {
  support::Plot plot{"one period of sn", {"u / 4K"}, {"sn u"}, {}};
  plot.series = {elliptic_sine("k² = 0: a sine", 1), elliptic_sine("k² = 0.9", 0.1),
                 elliptic_sine("k² = 0.9999", 1e-4), elliptic_sine("k² = 1 − 10⁻¹²", 1e-12)};
  return support::to_svg(plot);
}

// ── Against the clock ──

namespace {

/// A way of L, with a dot for each of `dots` equal times.
void draw_clock(support::Sketch& sketch, const Vec3& direction, const std::string& colour,
                int dots) {
  constexpr int between = 9;
  const Mat3 view = sphere_view();
  const Way way{reference::polhode_round({1, 2, 3}, direction, between * dots), {colour, 1.3}};
  sketch.curves(visible(way, view, false), {colour, 1, 0.3});
  sketch.curves(visible(way, view, true), way.pen);
  std::vector<Vec2> near;
  for (std::size_t i = between / 2; i < way.points.size(); i += between)
    if ((view * way.points[i]).z() >= 0) near.push_back((view * way.points[i]).head<2>());
  sketch.dots(near, colour, 3.6);
}

/// What its colours mean, at the right.
void clock_words(support::Sketch& sketch) {
  sketch.look({430, 215, 1});
  sketch.words({0, 45}, {0, 0}, "around the axis of");
  sketch.words({0, 15}, {0, 0}, "the largest moment", "c2");
  sketch.words({0, -15}, {0, 0}, "the largest, near the middle axis", "c1");
  sketch.words({0, -45}, {0, 0}, "the least", "c0");
}

}  // namespace

std::string clock_figure() {
  support::Sketch sketch(760, 440, "The way of L in the body, with dots that are as long apart",
                         18);
  clock_words(sketch);
  sketch.look({200, 215, 190});  // at the left, where a phone begins
  std::vector<Vec2> circle;
  for (int i = 0; i <= 90; ++i)
    circle.emplace_back(std::cos(2 * pi * i / 90), std::sin(2 * pi * i / 90));
  sketch.curve(circle, {"faint", 1.2, 1, 0.05});
  const auto toward = [](double angle, bool largest) -> Vec3 {
    const double a = angle * degree;
    return largest ? Vec3(0, std::sin(a), std::cos(a)) : Vec3(std::cos(a), std::sin(a), 0);
  };
  draw_clock(sketch, toward(89.97, true), "c1", 48);
  draw_clock(sketch, toward(62, true), "c2", 48);
  draw_clock(sketch, toward(24, true), "c2", 48);
  draw_clock(sketch, toward(40, false), "c0", 48);
  const std::array<std::string, 3> names{"least", "middle", "largest"};
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Vec2 tip = (sphere_view() * Vec3::Unit(i)).head<2>();
    sketch.dot(tip, "ink", 4);
    sketch.words(tip, {10, -10}, names[static_cast<std::size_t>(i)]);
  }
  return sketch.svg();
}

// ── Far in the future ──

namespace {

/// Where two free bodies with the moments 1, 2, 3 are after 1 s, 10 s, … 10⁶ s, to all digits of a
/// double: by Taylor series of order 36 in double-doubles over one round of ω in the body, and the
/// turn of a round to the power of the rounds.
struct KnownFuture {
  Vec3 omega;
  std::array<Quat, 7> ends;
};

const KnownFuture askew_future{
    {1, 1, 1},
    {Quat{0.68746473298110322, 0.17520159195580151, 0.54071725242305124, 0.45201935358504236},
     {0.46254544055464281, -0.31433514514460553, 0.049429631279299835, 0.82752754848441368},
     {-0.7543620159814326, 0.61119278548019473, -0.18605443580498179, -0.15088099528661478},
     {0.35394187810829708, -0.058004060239544838, -0.07949712833472386, 0.93007574019723316},
     {0.73662404581872665, -0.22694919357891749, -0.33911992414499548, -0.53932991359966498},
     {0.3779549144659371, -0.51306336252208162, 0.017696720176623423, -0.77045628997599303},
     {-0.53284041219367462, 0.59910872806697735, -0.14182271324484111, 0.58054814192719206}}};

const KnownFuture middle_future{
    {1e-3, 2, 1e-3},
    {Quat{0.54030214768834472, 4.4693933716989937e-05, 0.84147094329178818, 0.0004886731449068694},
     {-0.088511624516844203, 0.99310319383441736, -0.057246751031507705, -0.051327850311554395},
     {-0.071789099212623469, 0.49189772662808384, 0.041722294314205266, 0.86668460349167498},
     {-0.0048434757531086604, 0.9003332548212114, -0.0064919445353302197, -0.43512575844440976},
     {0.74244715706754172, -0.00046800653831446942, -0.66990035224478062, -0.0023490411924816774},
     {-0.50895777959042532, -0.00020732070754202607, -0.86074730938590305, -0.0087180845050227884},
     {0.40744150279865032, 0.00012718396130424528, -0.91323009360057827, -0.0014838341202590985}}};

RigidBody<> one_two_three() { return {1, Vec3(1, 2, 3).asDiagonal()}; }

double future_error(const KnownFuture& known, std::size_t i) {
  const RigidBodyState<> start = turning_state(one_two_three(), Quat::Identity(), known.omega);
  const double t = std::pow(10, i);
  return angle_between(FreeTrajectory(one_two_three(), start).at(t).q, known.ends[i]);
}

/// Errors at 1 s, 10 s, … as far as somebody has the patience: 10⁴ s.
template <class Method>
std::vector<double> stepped_errors(const KnownFuture& known, int rate) {
  const RigidBodyState<> start = turning_state(one_two_three(), Quat::Identity(), known.omega);
  const RigidBodyRhs motion(one_two_three());
  std::vector<double> errors;
  PackedState<double> y = pack(start);
  for (int i = 0, before = 0; i <= 4; ++i) {
    const int t = static_cast<int>(std::lround(std::pow(10, i)));
    y = integrate_fixed<Method>(motion, y, before, t, (t - before) * rate);
    errors.push_back(angle_between(unpack<double>(y).q, known.ends[static_cast<std::size_t>(i)]));
    if (errors.back() > 0.5) break;  // lost
    before = t;
  }
  return errors;
}

const std::vector<double>& rk4_errors() {
  static const std::vector<double> errors = stepped_errors<Rk4>(askew_future, 30);
  return errors;
}

support::Series growth(const std::string& name, const std::vector<double>& errors) {
  support::Series series{name, {}, {}};
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (errors[i] > 0.5) break;
    series.x.push_back(std::pow(10, i));
    series.y.push_back(errors[i]);
  }
  return series;
}

}  // namespace

Table future_table() {
  Table table({"after", "RK4, 30 steps/s", "its evaluations", "closed form", "near the middle axis",
               "promised"});
  const std::vector<double>& rk4 = rk4_errors();
  for (std::size_t i = 0; i < 7; ++i) {
    const double t = std::pow(10, i), rate = askew_future.omega.norm();
    const std::string evaluations = "1.2e" + std::to_string(2 + i);
    table.add({"1e" + std::to_string(i) + " s",
               i < rk4.size() ? error_number(rk4[i]) + " rad" : "–",
               i < rk4.size() ? evaluations : "–", below(future_error(askew_future, i)) + " rad",
               below(future_error(middle_future, i)) + " rad",
               error_number(1e-13 * std::max(1.0, rate * t)) + " rad"});
  }
  return table;
}

std::string future_figure() {
  support::Plot plot{"a free body, 1.7 rad/s",
                     {"time [s]", support::Scale::log},
                     {"orientation off by [rad]", support::Scale::log},
                     {}};
  support::Series promised{"closed form: promised", {}, {}};
  for (int i = 0; i <= 6; ++i) {
    promised.x.push_back(std::pow(10, i));
    promised.y.push_back(1e-13 * askew_future.omega.norm() * std::pow(10, i));
  }
  plot.series = {
      growth("midpoint, 60 steps/s", stepped_errors<runge_kutta::Midpoint>(askew_future, 60)),
      growth("RK4, 30", rk4_errors()), growth("DOP853, 5", stepped_errors<Dop853>(askew_future, 5)),
      promised};
  return support::to_svg(plot);
}

// ── What the start decides ──

Table condition_table() {
  Table table({"turned at the start by", "askew: off after 100 s", "near the middle axis"});
  const auto apart = [](const Vec3& omega, double by) {
    const RigidBodyState<> start = turning_state(one_two_three(), Quat::Identity(), omega);
    RigidBodyState<> other = start;
    other.q = turn({0, 0, by});
    return error_number(angle_between(FreeTrajectory(one_two_three(), start).at(100).q,
                                      FreeTrajectory(one_two_three(), other).at(100).q)) +
           " rad";
  };
  for (const double by : {1e-4, 1e-6, 1e-8, 1e-10})
    table.add({number(by) + " rad", apart(askew_future.omega, by), apart(middle_future.omega, by)});
  return table;
}

}  // namespace scene_chapter
