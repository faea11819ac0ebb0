#include "judge/mine/measure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "judge/protocol/finding.hpp"
#include "judge/verdict/number_text.hpp"

namespace tumble::judge::mine {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double long_measurement =
    0.35;  // [s]: four times that comes near what a process is given
constexpr double floor_of_rounding = 1e-10;  // [rad], at the end of these motions

struct Ladder {
  Method method;
  int fewest, factor, most;
};
constexpr std::array<Ladder, 4> ladders = {
    Ladder{Method::euler, 128, 4, 1 << 17}, Ladder{Method::midpoint, 64, 4, 1 << 16},
    Ladder{Method::rk4, 32, 2, 4096}, Ladder{Method::simulate, 32, 2, 4096}};

// ── Mass properties ──

mirtich::Polyhedron polyhedron_of(const PolygonMesh& mesh) {
  mirtich::Polyhedron body{mesh.vertices, {}};
  for (int f = 0; f < mesh.face_count(); ++f)
    body.faces.emplace_back(mesh.face(f).begin(), mesh.face(f).end());
  return body;
}

double error_of(const mirtich::MassProperties& own, const Problem& problem) {
  const double size = bounds(problem.mesh).sizes().norm();
  return std::max({std::abs(own.mass - problem.exact.mass) / problem.exact.mass,
                   (own.centre - problem.exact.centre).norm() / size,
                   (own.inertia - problem.exact.inertia).norm() / problem.exact.inertia.norm()});
}

MassResult mass_of(const OwnEngine& engine, const Problem& problem) {
  MassResult result;
  try {
    result.own = engine.mass(polyhedron_of(problem.mesh), problem.density);
    const mirtich::MassProperties& own = result.own->answer;
    require(std::isfinite(own.mass) && own.centre.allFinite() && own.inertia.allFinite(),
            "a number in the answer is not finite");
    result.error = error_of(own, problem);
    require_valid(MassProperties{own.mass, Vec3::Zero(), own.inertia});
  } catch (const NoAnswer& why) {
    result.failure = text_of(why);
  } catch (const std::invalid_argument& why) {
    result.failure = why.what();
  }
  return result;
}

// ── Curves ──

/// By which power of the step the error fell at last, where it is more than rounding.
double order_of(const std::vector<Point>& points) {
  double order = nan;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Point &rough = points[i - 1], &fine = points[i];
    if (rough.error > 0.5 || fine.error < floor_of_rounding) continue;
    order = std::log(rough.error / fine.error) / std::log(double(fine.steps) / rough.steps);
  }
  return order;
}

OwnCurve curve_of(const OwnEngine& engine, const ProblemResult& result, const Ladder& ladder) {
  OwnCurve own{ladder.method, {name_of(ladder.method), true, {}}, 0, 0, {}};
  std::vector<Point>& points = own.curve.points;
  try {
    for (int steps = ladder.fewest; steps <= ladder.most; steps *= ladder.factor) {
      const Timed<RunAnswer> run = engine.run(result.question(ladder.method, steps));
      own.states = run.answer.states;
      points.push_back(
          {steps, run.answer.evaluations, run.seconds, result.problem.error(own.states.back())});
      if (!std::isfinite(points.back().error))
        throw NoAnswer(Outcome::wrong,
                       "the state after " + std::to_string(steps) + " steps is not a number");
      if (run.seconds > long_measurement) break;
    }
  } catch (const NoAnswer& why) {
    own.failure = text_of(why);
  }
  own.order = order_of(points);
  if (!points.empty())
    own.twin_error = library_run(result.problem, ladder.method, points.back().steps).error;
  return own;
}

Curve own_closed_form(const OwnEngine& engine, const ProblemResult& result) {
  const Mat3 I = result.body().inertia;
  const RigidBodyState<>& start = result.problem.start;
  const auto top = engine.top((I(0, 0) + I(1, 1)) / 2, I(2, 2), coefficients(start.q), start.L,
                              result.problem.duration);
  Numbers y = pack(start);
  y.segment<4>(3) = top.answer;
  return {"closed form", true, {{0, 0, top.seconds, result.problem.error(y)}}};
}

// ── The choice of a model, and the drift of the energy ──

Chosen chosen_for(const OwnEngine& engine, const Problem& problem) {
  constexpr double tolerance = 1e-9;
  const only_what_a_scene_needs::Scene scene{principal_axes(problem.exact.inertia).moments,
                                             problem.omega(),
                                             problem.duration,
                                             true,
                                             false,
                                             problem.pull.has_value()};
  Chosen chosen;
  try {
    chosen.choice = engine.choose(scene, tolerance);
    chosen.right = model_of(chosen.choice->model) == problem.model &&
                   chosen.choice->steps == problem.pull.has_value();
  } catch (const NoAnswer& why) {
    chosen.failure = text_of(why);
  }
  return chosen;
}

/// All of the student's, but for methods that have given up before.
void take_curves(const OwnEngine& engine, ProblemResult& result, std::set<Method>& gave_up) {
  for (const Ladder& ladder : ladders) {
    if (gave_up.contains(ladder.method)) continue;
    result.own.push_back(curve_of(engine, result, ladder));
    if (!result.own.back().failure.empty()) gave_up.insert(ladder.method);
  }
  if (!result.chosen.right || result.problem.model != Model::symmetric_top) return;
  try {
    result.closed_form = own_closed_form(engine, result);
  } catch (const NoAnswer& why) {
    result.closed_form_failure = text_of(why);
  }
}

}  // namespace

MassProperties ProblemResult::body() const {
  if (!mass.failure.empty()) return problem.exact;
  const mirtich::MassProperties& measured = mass.own->answer;
  return {measured.mass, Vec3::Zero(), measured.inertia};
}

Setting ProblemResult::setting() const {
  const MassProperties moved = body();
  Setting setting{moved.mass, moved.inertia};
  if (const auto& pull = problem.pull) {
    setting.gravity = pull->gravity;
    setting.stiffness = pull->spring.stiffness;
    setting.p_body = pull->spring.p_body;
    setting.anchor = pull->spring.anchor;
  }
  return setting;
}

RunQuestion ProblemResult::question(Method method, int steps) const {
  return {setting(), pack(problem.start), problem.duration, method, steps, 1, samples};
}

bool OwnCurve::right() const {
  constexpr double as_good = 10;
  return failure.empty() && !curve.points.empty() &&
         curve.points.back().error <= as_good * twin_error + floor_of_rounding;
}

Measurement measure(const OwnEngine& engine,
                    const std::function<void(const std::string&)>& progress) {
  Measurement all;
  std::set<Method> gave_up;  // each try of one that hung would cost seconds
  for (Problem& problem : problems()) {
    progress(problem.sentence);
    ProblemResult result{.problem = std::move(problem)};
    const ProblemResult* before = all.problems.empty() ? nullptr : &all.problems.back();
    const bool same_mesh = before && before->problem.mesh.corners == result.problem.mesh.corners;
    result.mass = same_mesh ? before->mass : mass_of(engine, result.problem);
    result.chosen = chosen_for(engine, result.problem);
    take_curves(engine, result, gave_up);
    result.library = library_curves(result.problem);
    look_at_invariants(engine, result);
    all.problems.push_back(std::move(result));
  }
  all.drift = drift_of(engine, all.problems.front());
  return all;
}

std::string text_of(const NoAnswer& why) {
  const std::string detail = one_line(why.what());
  return tumble::judge::name_of(why.outcome) + (detail.empty() ? "" : ": " + detail);
}

std::string name_of(Method method) {
  constexpr const char* names[] = {"Euler", "midpoint", "RK4", "simulate"};
  return names[static_cast<int>(method)];
}

std::string unit_of(Method method) {
  constexpr const char* units[] = {"1.3 euler_step", "1.4 midpoint_step", "1.5 rk4_step",
                                   "9.5 simulate"};
  return units[static_cast<int>(method)];
}

std::string number_of(Method method) {
  const std::string unit = unit_of(method);
  return unit.substr(0, unit.find(' '));
}

int order_of(Method method) {
  constexpr int orders[] = {1, 2, 4, 4};
  return orders[static_cast<int>(method)];
}

}  // namespace tumble::judge::mine
