#include "judge/mine/own_engine.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "judge/protocol/convert.hpp"
#include "judge/verdict/finding.hpp"

namespace tumble::judge::mine {

namespace {

/// One process, asked by the clock.
class Asker {
 public:
  explicit Asker(const WorkerProgram& program) : worker_(program) { worker_.start_case(); }

  template <class T, class... Arguments>
  Timed<T> ask(Topic topic, const Arguments&... arguments) {
    Call call;
    call.arguments = List{to_value(topic), to_value(arguments)...};
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

constexpr double long_enough = 0.02;  // [s]: against the clock and the pipe
constexpr double enough_time = 0.3;  // [s] of processor time, of the two seconds that a process has
constexpr int most_repeats = 10000;

/// The least time of one of several repeats, without that of the way there and back.
/// @param ask gives the timed answer to the question with so many repeats; with 0 it costs the way
template <class Ask>
auto timed(Ask&& ask) {
  auto result = ask(1);  // starts the process
  if (result.seconds > enough_time) return result;
  const double once = std::min(ask(1).seconds, result.seconds);
  double way = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) way = std::min(way, ask(0).seconds);
  const int repeats =
      std::clamp(static_cast<int>(long_enough / std::max(once - way, 1e-6)), 1, most_repeats);
  double least = once;
  for (double spent = once; spent < enough_time && spent < 5 * long_enough;) {
    const double seconds = ask(repeats).seconds;
    spent += seconds;
    least = std::min(least, way + (seconds - way) / repeats);
  }
  result.seconds = std::max(least - way, 1e-9);
  return result;
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
    const auto states = static_cast<std::size_t>(question.samples) + 1;
    if (repeats > 0 && timed.answer.states.size() != states)
      throw NoAnswer(Outcome::malformed, "not as many states as were asked for");
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

}  // namespace tumble::judge::mine
