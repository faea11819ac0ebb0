/// @file
/// Evaluations of the forces that an error needs, by every method.

#include "common.hpp"
#include "parts.hpp"
#include "work_curves.hpp"

namespace scene_chapter {

namespace {

constexpr WorkRange of_the_table{3e-12, 0.1, 6e4};

std::string work_for(const WorkCurve& curve, double error) {
  const double least = curve.work_for(error);
  return std::isinf(least) ? "–" : number(least, 6);
}

}  // namespace

Table work_table() {
  Table table({"method", "1e-3 rad", "1e-6 rad", "1e-9 rad", "1e-11 rad"});
  const auto add = [&](const WorkCurve& curve) {
    table.add({curve.name, work_for(curve, 1e-3), work_for(curve, 1e-6), work_for(curve, 1e-9),
               work_for(curve, 1e-11)});
  };
  const KnownTurning& scene = lopsided_body();
  const std::vector<Steps> all = rivals(scene);
  add(by_fixed_steps(scene, all[0], of_the_table));
  add(by_tolerances<DormandPrince54>(scene, "DP 5(4), adaptive", of_the_table));
  add(by_tolerances<Dop853>(scene, "DOP853, adaptive", of_the_table));
  for (std::size_t i = 3; i <= 6; ++i) add(by_fixed_steps(scene, all[i], of_the_table));
  add(by_taylor(scene, of_the_table));
  return table;
}

}  // namespace scene_chapter
