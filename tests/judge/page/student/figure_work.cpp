/// @file
/// Topic "work": a scene, and numbers of steps. Answered for each of these with what the run by 9.5
/// cost, in evaluations of the forces, and the q in which it ended (w, x, y, z).
#include "judge/mine/student/engine_run.hpp"
#include "judge/page/student/figure_numbers.hpp"

using namespace tumble::judge;

namespace {

figure::AllNumbers work(figure::Numbers numbers) {
  mine::RunQuestion question = numbers.scene();
  figure::AllNumbers all;
  while (!numbers.end()) {
    question.steps = numbers.count();
    const mine::RunAnswer answer = mine::run(question);
    const mine::Numbers& state = answer.states.back();
    all.push_back(answer.evaluations);
    all.insert(all.end(), {state[3], state[4], state[5], state[6]});
  }
  return all;
}

}  // namespace

int main() { return figure::serve_figure(work); }
