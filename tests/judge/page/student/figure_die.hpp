#pragma once
/// @file
/// Topic "die": mass [kg], edge [m], gravity [m/s²], e, tolerance [m], hop [m/s], the state at the
/// start (13 numbers), the duration [s] and the most impacts. Answered with 14 numbers for each
/// impact on a table without friction: when, and the state right after it.

#include "judge/mine/student/die_run.hpp"
#include "judge/page/student/figure_numbers.hpp"

namespace tumble::judge::figure {

inline AllNumbers die(Numbers numbers) {
  mine::DieQuestion question;
  question.mass = numbers.number();
  question.edge = numbers.number();
  question.gravity = numbers.number();
  question.e = numbers.number();
  question.tolerance = numbers.number();
  question.hop = numbers.number();
  question.start = numbers.matrix<mine::Numbers>();
  question.duration = numbers.number();
  question.max_impacts = numbers.count();
  AllNumbers all;
  for (const mine::DieImpact& impact : mine::DieOnTable(question).run().impacts) {
    all.push_back(impact.t);
    all.insert(all.end(), impact.after.begin(), impact.after.end());
  }
  return all;
}

}  // namespace tumble::judge::figure
