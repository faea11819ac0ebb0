/// @file
/// What figures ask of an engine that is made of a reader's functions: a topic and numbers, for
/// numbers. It runs in the student's module, and nothing that it says is judged.
///
/// - "motion": a scene, steps, and samples, of which the steps are a multiple. The state at the
///   start and at each sample, 13 numbers each.
/// - "work": a scene, and numbers of steps. For each of these what the run cost, in evaluations of
///   the forces, and the q in which it ended.
/// - "impact": K by rows, u, e and μ, as 11.6 takes them. The impulse.
///
/// A scene: mass [kg], inertia by rows [kg m²], a constant force [N] and the point of the body
/// where it acts [m], the state at the start, the duration [s]: 30 numbers. A state: x, q as (w, x,
/// y, z), P, L.
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "11_when_bodies_meet/contract.hpp"
#include "judge/mine/engine_run.hpp"
#include "judge/worker/serve.hpp"

namespace {

using namespace tumble::judge;
using mine::RunAnswer;
using mine::RunQuestion;

using AllNumbers = std::vector<double>;

/// The numbers of a question, one after the other.
class Numbers {
 public:
  explicit Numbers(const AllNumbers& all) : all_(all) {}

  bool end() const { return next_ == all_.size(); }
  double number() { return all_.at(next_++); }
  int count() { return static_cast<int>(number()); }
  /// A vector, or a symmetric matrix.
  template <class Matrix>
  Matrix matrix() {
    Matrix read;
    for (Eigen::Index i = 0; i < read.size(); ++i) read(i) = number();
    return read;
  }

 private:
  const AllNumbers& all_;
  std::size_t next_ = 0;
};

RunQuestion scene_in(Numbers& numbers) {
  RunQuestion question;
  question.setting.mass = numbers.number();
  question.setting.inertia = numbers.matrix<Eigen::Matrix3d>();
  question.setting.pull = numbers.matrix<Eigen::Vector3d>();
  question.setting.p_body = numbers.matrix<Eigen::Vector3d>();
  question.start = numbers.matrix<mine::Numbers>();
  question.duration = numbers.number();
  question.method = mine::Method::simulate;
  return question;
}

AllNumbers motion(Numbers numbers) {
  RunQuestion question = scene_in(numbers);
  question.steps = numbers.count();
  question.samples = numbers.count();
  AllNumbers all;
  for (const mine::Numbers& state : mine::run(question).states)
    all.insert(all.end(), state.begin(), state.end());
  return all;
}

AllNumbers work(Numbers numbers) {
  RunQuestion question = scene_in(numbers);
  AllNumbers all;
  while (!numbers.end()) {
    question.steps = numbers.count();
    const RunAnswer answer = mine::run(question);
    const mine::Numbers& state = answer.states.back();
    all.push_back(answer.evaluations);
    all.insert(all.end(), {state[3], state[4], state[5], state[6]});
  }
  return all;
}

AllNumbers impact(Numbers numbers) {
  const auto K = numbers.matrix<Eigen::Matrix2d>();
  const auto u = numbers.matrix<Eigen::Vector2d>();
  const double e = numbers.number(), mu = numbers.number();
  const Eigen::Vector2d j = when_bodies_meet::collide_with_friction(K, u, e, mu).impulse;
  return {j.x(), j.y()};
}

Value answer(const List& question) {
  static const std::map<std::string, AllNumbers (*)(Numbers)> topics{
      {"motion", motion}, {"work", work}, {"impact", impact}};
  const auto topic = from_value<std::string>(question.at(0));
  const auto numbers = from_value<AllNumbers>(question.at(1));
  const auto found = topics.find(topic);
  if (found == topics.end()) throw Malformed("a figure asked for " + topic);
  return to_value(found->second(Numbers(numbers)));
}

}  // namespace

int main() { return serve_questions(answer); }
