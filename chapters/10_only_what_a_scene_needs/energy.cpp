/// @file
/// The energy as a witness: how far it strays, and whether it swings or runs away.

#include "common.hpp"
#include "parts.hpp"
#include "rivals.hpp"
#include "tilted_top.hpp"

namespace scene_chapter {

// ── How far, and where to ──

namespace {

/// Numbers one after the other, and the line that fits them best.
class Witness {
 public:
  explicit Witness(double h) : h_(h) {}

  void see(double e) {
    largest_ = std::max(largest_, std::abs(e));
    last_ = e;
    sum_ += e;
    weighted_ += count_ * e;
    ++count_;
  }

  double largest() const { return largest_; }
  /// Σ (n − n̄) eₙ / Σ (n − n̄)², a second.
  double trend() const {
    const double above = weighted_ - (count_ - 1) / 2 * sum_;
    return above / (count_ * (count_ * count_ - 1) / 12) / h_;
  }
  double from_first_to_last() const { return last_ / ((count_ - 1) * h_); }

 private:
  double h_, largest_ = 0, last_ = 0, sum_ = 0, weighted_ = 0, count_ = 0;
};

// ── A free body ──

template <class Method>
void add_free_row(Table& table, const std::string& name, int rate) {
  const RigidBodyRhs motion(handle());
  const double first = kinetic_energy(handle(), handle_start());
  Witness after_20(1.0 / rate), after_200(1.0 / rate);
  after_20.see(0), after_200.see(0);
  integrate_fixed<Method>(motion, pack(handle_start()), 0, 200, 200 * rate,
                          [&](double t, const PackedState<double>& y) {
                            const double now = kinetic_energy(handle(), unpack<double>(y));
                            const double e = (now - first) / first;
                            if (t < 20.001) after_20.see(e);
                            after_200.see(e);
                          });
  table.add({name, std::to_string(rate), error_number(after_20.largest()),
             error_number(after_200.largest()), error_number(after_20.trend()),
             error_number(after_200.trend())});
}

}  // namespace

Table free_energy_table() {
  Table table({"method", "steps/s", "largest, 20 s", "200 s", "trend [1/s], 20 s", "200 s"});
  add_free_row<runge_kutta::Euler>(table, "Euler", 240);
  add_free_row<runge_kutta::Midpoint>(table, "midpoint", 120);
  add_free_row<Rk4>(table, "RK4", 60);
  add_free_row<Dop853>(table, "DOP853", 20);
  table.add({"closed form", "–", "< 1e-13", "< 1e-13", "0", "0"});
  return table;
}

// ── A heavy top ──

namespace {

/// A slow top that nutates by much, for all methods of this section.
const KnownTurning& nodding_top() {
  static const KnownTurning scene = tilted_top(18, 50 * degree, 0);
  return scene;
}

/// Takes the steps, and shows the energy's relative error after each.
template <class See>
void watch_energy(const KnownTurning& scene, const Steps& method, double h, double duration,
                  const See& see) {
  RigidBodyState<> state = scene.start;
  const double first = whole_energy(scene, state);
  const int steps = static_cast<int>(std::lround(duration / h));
  for (int i = 1; i <= steps; ++i) {
    state = method.step((i - 1) * h, state, h);
    see(i * h, (whole_energy(scene, state) - first) / first);
  }
}

constexpr double evaluations_a_second = 120;

double step_of(const Steps& method) { return method.evaluations / evaluations_a_second; }

/// What a witness says after 10 s, 100 s and 1000 s.
std::array<Witness, 3> witnesses(const Steps& method) {
  const double h = step_of(method);
  std::array<Witness, 3> seen{Witness(h), Witness(h), Witness(h)};
  for (Witness& each : seen) each.see(0);
  watch_energy(nodding_top(), method, h, 1000, [&](double t, double e) {
    for (std::size_t i = 0; i < 3; ++i)
      if (t < 10.001 * std::pow(10, i)) seen[i].see(e);
  });
  return seen;
}

/// A trend, or that rounding decides it.
std::string trend_number(double trend) {
  return std::abs(trend) < 1e-14 ? "< 1e-14" : error_number(trend);
}

/// The energy over time, with so many steps a second.
support::Series energy_of(const Steps& method, const std::string& name, int rate) {
  support::Series series{name, {0}, {0}};
  watch_energy(nodding_top(), method, 1.0 / rate, 40, [&](double t, double e) {
    series.x.push_back(t);
    series.y.push_back(1e6 * e);
  });
  return series;
}

}  // namespace

Table drift_table() {
  Table table(
      {"method", "largest 10 s", "100 s", "1000 s", "trend [1/s], 10 s", "100 s", "1000 s"});
  for (const Steps& method : rivals(nodding_top())) {
    const std::array<Witness, 3> seen = witnesses(method);
    std::vector<std::string> row{method.name};
    for (const Witness& each : seen) row.push_back(error_number(each.largest()));
    for (const Witness& each : seen) row.push_back(trend_number(each.trend()));
    table.add(row);
  }
  return table;
}

Table ends_table() {
  Table table({"looked at for", "from first to last [1/s]", "fitted line [1/s]"});
  const Steps method = rivals(nodding_top())[3];
  const double h = step_of(method);
  Witness seen(h);
  seen.see(0);
  const std::array<double, 5> until{99.6, 99.7, 99.8, 99.9, 100};
  std::size_t next = 0;
  watch_energy(nodding_top(), method, h, 100.01, [&](double t, double e) {
    seen.see(e);
    if (next == until.size() || t < until[next] - h / 2) return;
    table.add({support::svg_number(until[next], 1) + " s", error_number(seen.from_first_to_last()),
               error_number(seen.trend())});
    ++next;
  });
  return table;
}

std::string drift_figure() {
  support::Plot plot{"the energy of a nodding top", {"time [s]"}, {"off by [millionths]"}, {}};
  const std::vector<Steps> all = rivals(nodding_top());
  plot.series = {energy_of(all[0], "RK4: 200 per second", 50),
                 energy_of(all[3], "splitting: 50 per second", 50)};
  return support::to_svg(plot);
}

// ── What spoils it ──

namespace {

/// A splitting whose steps follow the motion: shorter where the axis is low.
Witness with_changing_steps() {
  const KnownTurning& scene = nodding_top();
  const Steps method = rivals(scene)[3];
  const double h = step_of(method), first = whole_energy(scene, scene.start);
  RigidBodyState<> state = scene.start;
  Witness seen(h);
  seen.see(0);
  for (double t = 0; t < 1000;) {
    const double height = (state.q * Vec3::UnitZ()).z();
    const double step = h * (0.4 + height);
    state = method.step(t, state, step);
    t += step;
    seen.see((whole_energy(scene, state) - first) / first);
  }
  return seen;
}

/// The order that a splitting shows with a drag that it takes for a force of the place alone.
std::vector<double> with_drag(double angular_drag) {
  KnownTurning scene = nodding_top();
  scene.forces.angular_drag = angular_drag;
  const HeldRhs motion(scene.body, scene.forces);
  const RigidBodyState<> exact = followed(motion, scene.start, 2);
  const Steps method = of_splitting<geometric::BlanesMoan4>(scene, "");
  std::vector<double> errors;
  for (const int steps : {40, 80, 160, 320}) {
    RigidBodyState<> state = scene.start;
    for (int i = 0; i < steps; ++i) state = method.step(i * 2. / steps, state, 2. / steps);
    errors.push_back(angle_between(state.q, exact.q));
  }
  return errors;
}

}  // namespace

Table spoiled_table() {
  Table table({"splitting of order 4", "20 steps/s", "40", "80", "160", "order"});
  for (const double drag : {0., 0.05}) {
    const std::vector<double> errors = with_drag(drag);
    std::vector<std::string> row{drag == 0 ? "no drag" : "drag, 0.05 N m s"};
    for (const double error : errors) row.push_back(error_number(error) + " rad");
    row.push_back(order_text(errors[2], errors[3]));
    table.add(row);
  }
  return table;
}

Table changing_table() {
  Table table({"splitting of order 2, 1000 s", "largest", "trend [1/s]"});
  const auto add = [&](const std::string& name, const Witness& seen) {
    table.add({name, error_number(seen.largest()), error_number(seen.trend())});
  };
  add("steps of one length", witnesses(rivals(nodding_top())[3])[2]);
  add("shorter where the axis is low", with_changing_steps());
  return table;
}

}  // namespace scene_chapter
