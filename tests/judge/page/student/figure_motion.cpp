/// @file
/// Topic "motion": a scene, steps, and samples, of which the steps are a multiple. Answered with
/// the states at the start and at each sample, 13 numbers each, by 9.5.
#include "judge/mine/student/engine_run.hpp"
#include "judge/page/student/figure_numbers.hpp"

using namespace tumble::judge;

namespace {

figure::AllNumbers motion(figure::Numbers numbers) {
  mine::RunQuestion question = numbers.scene();
  question.steps = numbers.count();
  question.samples = numbers.count();
  figure::AllNumbers all;
  for (const mine::Numbers& state : mine::run(question).states)
    all.insert(all.end(), state.begin(), state.end());
  return all;
}

}  // namespace

int main() { return figure::serve_figure(motion); }
