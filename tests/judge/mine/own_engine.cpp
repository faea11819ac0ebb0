#include "judge/mine/own_engine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "judge/protocol/convert.hpp"
#include "judge/protocol/finding.hpp"

namespace tumble::judge::mine {

namespace {

/// One process, asked by the clock.
class Asker {
 public:
  explicit Asker(const WorkerProgram& program) : worker_(program) { worker_.start_case(); }

  template <class T, class... Arguments>
  Timed<T> ask(const Arguments&... arguments) {
    Call call;
    call.arguments = List{to_value(arguments)...};
    const auto start = Clock::now();
    const Value value = worker_.ask(call, [](FunctionId, const List&) -> Value {
      throw Malformed("it called a function that it was not given");
    });
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    try {
      return {from_value<T>(value), seconds};
    } catch (const Malformed& why) {
      throw NoAnswer(Outcome::malformed, why.what());
    }
  }

 private:
  StudentWorker worker_;
};

constexpr double slice = 0.004;  // [s]: long against the clock, and short enough to be let alone
constexpr double spent_on_it = 0.06;  // [s] on slices
constexpr double long_run = 0.3;      // [s], of the two seconds that a process has: once will do
constexpr int most_repeats = 10000;

/// The least time of one of several repeats, without that of the way there and back.
/// @param ask gives the timed answer to the question with so many repeats; with 0 it costs the way
template <class Ask>
auto timed(Ask&& ask) {
  auto result = ask(1);  // starts the process
  if (result.seconds > long_run) return result;
  double least = ask(1).seconds, way = least;
  for (int i = 0; i < 5; ++i) way = std::min(way, ask(0).seconds);
  // What takes long on its way needs a longer question.
  const double enough = std::max(slice, 2 * way);
  int repeats = 1;
  // Once more where it seems long enough: it may have been stopped meanwhile.
  const auto is_enough = [&] { return ask(repeats).seconds - way >= enough; };
  while (repeats < most_repeats && !(is_enough() && is_enough())) repeats *= 2;
  for (double spent = 0; spent < spent_on_it;) {
    const double seconds = ask(repeats).seconds;
    spent += seconds;
    least = std::min(least, way + (seconds - way) / repeats);
  }
  result.seconds = std::max(least - way, 1e-9);
  return result;
}

/// @param when in words
/// @throws NoAnswer if this is not the state of a body
void require_state(const Numbers& y, const std::string& when) {
  const double length = y.segment<4>(3).norm();
  if (y.allFinite() && length > 0 && std::isfinite(length)) return;
  throw NoAnswer(Outcome::wrong, when + (y.allFinite() ? " q has length 0, or its length overflows"
                                                       : " the state is no longer finite"));
}

void require_states(const RunAnswer& answer, const RunQuestion& question) {
  if (answer.states.size() != static_cast<std::size_t>(question.samples) + 1)
    throw NoAnswer(Outcome::malformed, "not as many states as were asked for");
  for (const Numbers& y : answer.states)
    require_state(y, "with " + std::to_string(question.steps) + " steps");
}

}  // namespace

Timed<mirtich::MassProperties> OwnEngine::mass(const mirtich::Polyhedron& mesh,
                                               double density) const {
  Asker asker(program_);
  return timed([&](int repeats) {
    return asker.ask<mirtich::MassProperties>(Topic::mass, mesh, density, repeats);
  });
}

Timed<RunAnswer> OwnEngine::run(RunQuestion question) const {
  Asker asker(program_);
  return timed([&](int repeats) {
    question.repeats = repeats;
    Timed<RunAnswer> timed = asker.ask<RunAnswer>(Topic::run, question);
    if (repeats > 0) require_states(timed.answer, question);
    return timed;
  });
}

Timed<quaternions::Quaternion> OwnEngine::top(double A, double C, const quaternions::Quaternion& q0,
                                              const Eigen::Vector3d& L, double t) const {
  Asker asker(program_);
  return timed([&](int repeats) {
    return asker.ask<quaternions::Quaternion>(Topic::top, A, C, q0, L, t, repeats);
  });
}

only_what_a_scene_needs::Choice OwnEngine::choose(const only_what_a_scene_needs::Scene& scene,
                                                  double tolerance) const {
  return Asker(program_)
      .ask<only_what_a_scene_needs::Choice>(Topic::choose, scene, tolerance)
      .answer;
}

only_what_a_scene_needs::EnergyDrift OwnEngine::drift(const Setting& setting,
                                                      const std::vector<Numbers>& states,
                                                      double h) const {
  return Asker(program_)
      .ask<only_what_a_scene_needs::EnergyDrift>(Topic::drift, setting, states, h)
      .answer;
}

DieAnswer drop_die(const WorkerProgram& program, const DieQuestion& question) {
  DieAnswer dropped = Asker(program).ask<DieAnswer>(question).answer;
  for (const DieImpact& impact : dropped.impacts) {
    require_state(impact.after, "at an impact");
    if (!std::isfinite(impact.t)) throw NoAnswer(Outcome::wrong, "a time is not a number");
  }
  return dropped;
}

}  // namespace tumble::judge::mine
