/// @file
/// 10.1 choose_model: its laws, and what goes wrong.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "10_only_what_a_scene_needs/contract.hpp"
#include "judge/spec/spec.hpp"

using namespace tumble::judge;
using only_what_a_scene_needs::Choice, only_what_a_scene_needs::Model,
    only_what_a_scene_needs::Scene;
using tumble::Vec3;

namespace student {
const Function<decltype(only_what_a_scene_needs::choose_model)> choose_model{TUMBLE_UNIT};
}

namespace {

/// A reader of the contract, taken apart so that each part can go wrong by itself.
struct Reader {
  using Equal = bool (*)(double larger, double smaller, const Scene&, double tolerance);

  static bool counts(const Scene& s) {
    return s.orientation_is_asked || s.force_depends_on_orientation;
  }
  static bool turned_right(double larger, double smaller, const Scene& s, double tolerance) {
    return (larger - smaller) / larger * s.omega * s.duration <= tolerance;
  }
  /// From all three pairs, of sorted moments.
  static Model by_pairs(bool low_middle, bool middle_high, bool low_high) {
    if (low_high) return Model::ball;
    return low_middle || middle_high ? Model::symmetric_top : Model::full_body;
  }
  static bool with_torque(const Scene& s, Model model) {
    return s.torque_acts && model != Model::particle;
  }

  bool (*orientation_counts)(const Scene&) = counts;
  Equal equal = turned_right;
  Model (*shape)(bool low_middle, bool middle_high, bool low_high) = by_pairs;
  bool (*steps)(const Scene&, Model) = with_torque;
  bool sorts = true;

  Choice operator()(const Scene& scene, double tolerance) const {
    Model model = Model::particle;
    if (orientation_counts(scene)) {
      Vec3 m = scene.moments;
      if (sorts) std::sort(m.begin(), m.end());
      const auto alike = [&](double a, double b) {
        return equal(std::fmax(a, b), std::fmin(a, b), scene, tolerance);
      };
      model = shape(alike(m[0], m[1]), alike(m[1], m[2]), alike(m[0], m[2]));
    }
    return {model, steps(scene, model)};
  }
};

// ── Tasks ──

struct Task {
  Scene scene;
  double tolerance;
};

bool any_bool() { return any_number(0, 1) < 0.5; }

/// The moments in any order.
Vec3 shuffled(Vec3 m) {
  for (int i = 2; i > 0; --i) std::swap(m[i], m[static_cast<int>(any_number(0, i + 1))]);
  return m;
}

/// A body of any size that spins somehow for some time. Its moments will count as equal if they
/// differ by up to `limit` of the larger one.
Task any_task(double limit) {
  const double turn = std::pow(10, any_number(-1, 3));  // a few degrees, or many turns
  Task task{};
  task.scene.omega = std::pow(10, any_number(-1, 4));
  task.scene.duration = turn / task.scene.omega;
  task.scene.orientation_is_asked = true;
  task.scene.torque_acts = any_bool();
  task.tolerance = limit * turn;
  return task;
}

/// One of each kind, never so near to a limit that rounding or the size of an angle decides.
enum class Kind { ball, needle_like, disc_like, chain, full, count };

Task task_of(Kind kind) {
  const double limit = std::pow(10, any_number(-7, -3.5));
  Task task = any_task(limit);
  const double near = 1 - limit * any_number(0.1, 0.4);  // equal, and so are two of them
  const double low = any_number(0.3, 0.7), high = any_number(1.05, 1.25);
  const double far = 1 - limit * any_number(3, 8);  // different, but only just
  Vec3 moments;
  switch (kind) {
    case Kind::ball:
      moments = {1, near, near * near};
      break;
    case Kind::needle_like:
      moments = {1, near, any_bool() ? low : far};
      break;
    case Kind::disc_like:
      moments = {1, near, any_bool() ? high : 1 / far};
      break;
    case Kind::chain:  // each equal to the middle one, but not the first to the last
      moments = {1, 1 - 0.7 * limit, 1 - 1.4 * limit};
      break;
    default:
      moments = {any_bool() ? low : far, 1, any_bool() ? high : 1 / far};
  }
  const double size = std::pow(10, any_number(-4, 4));
  task.scene.moments = size * shuffled(moments);
  return task;
}

/// Many tasks of all kinds; for each one, who asks for the orientation and what the force
/// depends on is drawn anew.
std::vector<Task> all_kinds(int of_each) {
  std::vector<Task> tasks;
  for (int n = 0; n < of_each * static_cast<int>(Kind::count); ++n) {
    Task task = task_of(static_cast<Kind>(n % static_cast<int>(Kind::count)));
    task.scene.orientation_is_asked = any_bool();
    task.scene.force_depends_on_orientation = any_bool();
    tasks.push_back(task);
  }
  return tasks;
}

/// Two moments that differ by this part of a large limit, and another one; seen for less than a
/// radian. Here it is of weight what the difference is a fraction of.
Task wide_apart(double part_of_limit, double third) {
  const double limit = any_number(0.2, 0.33), turn = any_number(0.1, 1);
  Task task = any_task(limit);
  task.scene.duration = turn / task.scene.omega;
  task.tolerance = limit * turn;
  const double other = 1 - part_of_limit * limit;
  task.scene.moments = shuffled({1, other, third * other});
  return task;
}

/// A choice says little. All is asked before the first answer is looked at, so that who
/// is wrong once can be told from who is wrong in another way.
void require_all(const std::vector<Task>& tasks) {
  std::vector<Answer<Choice>> answers;
  for (const auto& [scene, tolerance] : tasks)
    answers.push_back(student::choose_model(scene, tolerance));
  for (std::size_t n = 0; n < tasks.size(); ++n)
    REQUIRE(answers[n] == close_to(Reader{}(tasks[n].scene, tasks[n].tolerance), 0));
}

auto as(const Reader& reader) {
  return [reader](const Scene& scene, double tolerance) { return reader(scene, tolerance); };
}

}  // namespace

TEST_SUITE(TUMBLE_UNIT) {
  TEST_CASE("particles, balls, tops and full bodies, with and without a torque") {
    std::vector<Task> tasks = all_kinds(16);
    for (int n = 0; n < 10; ++n) tasks.push_back(wide_apart(0.9, 0.5));
    for (int n = 0; n < 3; ++n) tasks.push_back(wide_apart(1.2, 100));
    require_all(tasks);
  }

  TEST_CASE("where nobody asks and no force cares how it is turned: a particle, without steps") {
    std::vector<Task> tasks = all_kinds(4);
    for (Task& task : tasks) {
      task.scene.orientation_is_asked = false;
      task.scene.force_depends_on_orientation = false;
    }
    require_all(tasks);
  }

  TEST_CASE("a sail: nobody asks how it is turned, but the force does") {
    std::vector<Task> tasks = all_kinds(4);
    for (Task& task : tasks) {
      task.scene.orientation_is_asked = false;
      task.scene.force_depends_on_orientation = true;
    }
    require_all(tasks);
  }

  TEST_CASE("the right model whichever moment is the odd one, and in whatever order they come") {
    std::vector<Task> tasks;
    for (const Vec3& moments :
         {Vec3(2, 2, 2), Vec3(2, 2, 1), Vec3(2, 2, 3), Vec3(2, 2.5, 3), Vec3(2, 2, 2e-6)}) {
      std::array<double, 3> m{moments[0], moments[1], moments[2]};
      std::sort(m.begin(), m.end());
      do {
        Task task = any_task(1e-3);
        task.scene.moments = {m[0], m[1], m[2]};
        tasks.push_back(task);
      } while (std::next_permutation(m.begin(), m.end()));
    }
    require_all(tasks);
  }

  TEST_CASE("the same body is a ball for a second, a top for an hour, a full body for a year") {
    const double size = std::pow(10, any_number(-4, 4));
    std::vector<Task> tasks;
    for (const double duration : {1., 3600., 3e7}) {
      Task task = any_task(1);
      // 1 rad/s: wrong by 2e-6 rad a second as a ball, by 1e-9 rad a second as a top.
      task.scene.moments = size * shuffled({1, 1 - 1e-9, 1 - 2e-6});
      task.scene.omega = 1;
      task.scene.duration = duration;
      task.tolerance = 1e-3;
      tasks.push_back(task);
    }
    require_all(tasks);
    REQUIRE(student::choose_model(tasks[0].scene, 1e-3) ==
            close_to(Choice{Model::ball, tasks[0].scene.torque_acts}, 0));
    REQUIRE(student::choose_model(tasks[1].scene, 1e-3) ==
            close_to(Choice{Model::symmetric_top, tasks[1].scene.torque_acts}, 0));
    REQUIRE(student::choose_model(tasks[2].scene, 1e-3) ==
            close_to(Choice{Model::full_body, tasks[2].scene.torque_acts}, 0));
  }

  TEST_CASE(
      "no torque, no steps, not for a full body either; the right model with and without one") {
    std::vector<Task> tasks;
    for (Task task : all_kinds(4)) {
      for (const bool torque : {false, true}) {
        task.scene.torque_acts = torque;
        tasks.push_back(task);
      }
    }
    require_all(tasks);
  }

  TEST_CASE("with no tolerance at all only equal moments are equal, at rest all are") {
    std::vector<Task> tasks;
    for (const Vec3& moments :
         {Vec3(1, 1, 1), Vec3(1, 1, 1 - 1e-14), Vec3(1, 1 + 1e-14, 1), Vec3(1, 2, 1.5)}) {
      Task task = any_task(0);
      task.scene.duration = 1 / task.scene.omega;  // a radian: the difference itself decides
      task.scene.moments = shuffled(moments);
      tasks.push_back(task);
      task.scene.omega = 0;
      tasks.push_back(task);
      task.scene.omega = 10;
      task.scene.duration = 0;
      tasks.push_back(task);
    }
    require_all(tasks);
  }

  TEST_CASE("specks of dust and planets, and a spin of 10000 rad/s") {
    std::vector<Task> tasks;
    for (const double size : {1e-100, 1e-20, 1e20, 1e100}) {
      for (int kind = 0; kind < static_cast<int>(Kind::count); ++kind) {
        Task task = task_of(static_cast<Kind>(kind));
        task.scene.moments *= size;
        const double turn = task.scene.omega * task.scene.duration;
        task.scene.omega = 1e4;
        task.scene.duration = turn / 1e4;
        tasks.push_back(task);
      }
    }
    require_all(tasks);
  }
}

const Misconceptions<decltype(only_what_a_scene_needs::choose_model)> misconceptions{
    TUMBLE_UNIT,
    {{"a torque makes a body",
      "You follow the orientation because a torque acts. If nobody wants it and no force depends "
      "on it, the body may turn as it likes: its path is that of a particle.",
      "The ladder of models",
      as({.orientation_counts =
              [](const Scene& s) {
                return s.orientation_is_asked || s.force_depends_on_orientation || s.torque_acts;
              }})},
     {"only who asks counts",
      "Where nobody wants the orientation you dropped it, although a force depends on it. Then the "
      "orientation decides where the body flies.",
      "The ladder of models",
      as({.orientation_counts = [](const Scene& s) { return s.orientation_is_asked; }})},
     {"only the force counts",
      "Where no force depends on the orientation you dropped it, although the scene wants to know "
      "it.",
      "The ladder of models",
      as({.orientation_counts = [](const Scene& s) { return s.force_depends_on_orientation; }})},
     {"orientation only if both want it",
      "You follow the orientation only where the scene wants it and a force depends on it. One of "
      "the two is reason enough.",
      "The ladder of models",
      as({.orientation_counts =
              [](const Scene& s) {
                return s.orientation_is_asked && s.force_depends_on_orientation;
              }})},
     {"never a particle",
      "You gave every body an orientation, also where nobody wants it and no force depends on it.",
      "The ladder of models", as({.orientation_counts = [](const Scene&) { return true; }})},
     {"equal to the last digit",
      "You took only those moments for equal that are exactly equal. Nothing that is measured or "
      "computed ever is: what matters is what the difference does until the end.",
      "How equal is equal enough",
      as({.equal = [](double a, double b, const Scene&, double) { return a == b; }})},
     {"difference not relative",
      "You took the difference of the moments as it is, in kg m². A millionth of a heavy body's "
      "moments is a large number, a millionth of a light one's a tiny one, and both turn alike.",
      "How equal is equal enough",
      as({.equal = [](double a, double b, const Scene& s,
                      double tolerance) { return (a - b) * s.omega * s.duration <= tolerance; }})},
     {"divided by the turn",
      "You divided the tolerance by the angle that the body turns by. At rest that angle is 0, and "
      "without a tolerance 0/0 is not a number: no comparison with it is true. Multiply the "
      "difference by the angle instead.",
      "How equal is equal enough",
      as({.equal =
              [](double a, double b, const Scene& s, double tolerance) {
                return (a - b) / a <= tolerance / (s.omega * s.duration);
              }})},
     {"turn forgotten",
      "You compared the relative difference with the tolerance itself. But the tolerance is an "
      "angle, and the error grows with the angle that the body turns by.",
      "How equal is equal enough",
      as({.equal = [](double a, double b, const Scene&,
                      double tolerance) { return (a - b) / a <= tolerance; }})},
     {"spin forgotten",
      "You took the duration into account, but not how fast the body turns. What counts is the "
      "angle of the turn.",
      "How equal is equal enough",
      as({.equal = [](double a, double b, const Scene& s,
                      double tolerance) { return (a - b) / a * s.duration <= tolerance; }})},
     {"duration forgotten",
      "You took the spin into account, but not for how long. What counts is the angle of the turn: "
      "a ball for a second may be no ball for an hour.",
      "How equal is equal enough",
      as({.equal = [](double a, double b, const Scene& s,
                      double tolerance) { return (a - b) / a * s.omega <= tolerance; }})},
     {"fraction of the largest of all",
      "You divided each difference by the largest of all three moments. Then two moments that are "
      "nothing alike count as equal beside a huge third one: divide by the larger one of the two.",
      "How equal is equal enough",
      as({.equal =
              [](double a, double b, const Scene& s, double tolerance) {
                return (a - b) / s.moments.maxCoeff() * s.omega * s.duration <= tolerance;
              }})},
     {"fraction of the smaller one",
      "You divided the difference by the smaller of the two moments. For nearly equal ones that is "
      "the same; these differ by a lot, and the contract divides by the larger one.",
      "How equal is equal enough",
      as({.equal =
              [](double a, double b, const Scene& s, double tolerance) {
                return (a - b) / b * s.omega * s.duration <= tolerance;
              }})},
     {"a chain of equals",
      "The smallest moment is as good as equal to the middle one, and that one to the largest. But "
      "the smallest and the largest are too far apart for a ball.",
      "How equal is equal enough",
      as({.shape =
              [](bool low, bool high, bool) {
                if (low && high) return Model::ball;
                return low || high ? Model::symmetric_top : Model::full_body;
              }})},
     {"axis of symmetry assumed",
      "For a top you compared only the first two moments. They come in any order: the odd one may "
      "be the first or the second as well.",
      "The ladder of models",
      as({.shape =
              [](bool first, bool second, bool outer) {
                if (first && second && outer) return Model::ball;
                return first ? Model::symmetric_top : Model::full_body;
              },
          .sorts = false})},
     {"only discs are tops",
      "For a top you compared the two smaller moments, but not the two larger ones. A pencil is a "
      "top as well as a coin.",
      "The ladder of models",
      as({.shape =
              [](bool low, bool, bool outer) {
                if (outer) return Model::ball;
                return low ? Model::symmetric_top : Model::full_body;
              }})},
     {"only needles are tops",
      "For a top you compared the two larger moments, but not the two smaller ones. A coin is a "
      "top as well as a pencil.",
      "The ladder of models",
      as({.shape =
              [](bool, bool high, bool outer) {
                if (outer) return Model::ball;
                return high ? Model::symmetric_top : Model::full_body;
              }})},
     {"a ball taken for a top",
      "You called a body with three equal moments a top. It is one, but a ball is enough for it: "
      "one moment instead of two and an axis.",
      "The ladder of models",
      as({.shape = [](bool low, bool high,
                      bool) { return low || high ? Model::symmetric_top : Model::full_body; }})},
     {"a torque makes a full body",
      "Where a torque acts you chose a full body. But the moments of a ball or of a top stay "
      "equal, however you push it.",
      "The ladder of models",
      [](const Scene& scene, double tolerance) -> Choice {
        const Choice choice = Reader{}(scene, tolerance);
        return choice.steps ? Choice{Model::full_body, true} : choice;
      }},
     {"steps for every full body",
      "You gave a full body steps although no torque acts. Its free motion has a closed form too, "
      "with elliptic functions in place of sines.",
      "A body with three moments",
      as({.steps =
              [](const Scene& s, Model model) {
                return model == Model::full_body || Reader::with_torque(s, model);
              }})},
     {"no steps for balls and tops",
      "You gave a ball or a top no steps although a torque acts. In general only their free "
      "motion is known in closed form.",
      "The ladder of models",
      as({.steps = [](const Scene& s,
                      Model model) { return model == Model::full_body && s.torque_acts; }})},
     {"steps for the turning of a particle",
      "A torque acts, so you chose steps, for a turning that you don't compute at all.",
      "The ladder of models", as({.steps = [](const Scene& s, Model) { return s.torque_acts; }})},
     {"the wrong way round",
      "You chose steps where no torque acts, and none where one does. What nothing pushes is known "
      "for all times.",
      "Nothing pushes, no steps", as({.steps = [](const Scene& s, Model model) {
        return !s.torque_acts && model != Model::particle;
      }})}}};
