/// @file
/// Topic "impact": K by rows, u, e and μ, as 11.6 takes them. Answered with its impulse.
#include "11_when_bodies_meet/contract.hpp"
#include "judge/page/student/figure_numbers.hpp"

using namespace tumble::judge;

namespace {

figure::AllNumbers impact(figure::Numbers numbers) {
  const auto K = numbers.matrix<Eigen::Matrix2d>();
  const auto u = numbers.matrix<Eigen::Vector2d>();
  const double e = numbers.number(), mu = numbers.number();
  const Eigen::Vector2d j = when_bodies_meet::collide_with_friction(K, u, e, mu).impulse;
  return {j.x(), j.y()};
}

}  // namespace

int main() { return figure::serve_figure(impact); }
