#include "judge/mine/truth.hpp"

#include <algorithm>
#include <limits>

#include "judge/mine/motion_of.hpp"
#include "tumble/ode.hpp"
#include "tumble/quaternion.hpp"

namespace tumble::judge::mine {

Quat true_end(const Problem& problem) {
  using Real = long double;
  constexpr double eps = static_cast<double>(std::numeric_limits<Real>::epsilon());
  const double tolerance = std::max(1e-18, 4 * eps);
  const PackedState<Real> start = pack(problem.start).cast<Real>();
  const auto end = with_motion<Real>(problem, [&](const auto& motion) -> PackedState<Real> {
    return integrate_adaptive<Dop853>(motion, start, Real(0), Real(problem.duration),
                                      {tolerance, tolerance})
        .y;
  });
  return rotation::normalize(unpack<double>(PackedState<double>(end.cast<double>())).q);
}

}  // namespace tumble::judge::mine
