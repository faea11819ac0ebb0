/// @file
/// How the error falls with the number of points or columns, and how honest its estimate is.

#include "common.hpp"
#include "parts.hpp"
#include "support/plot.hpp"
#include "tumble/ode/observed_order.hpp"
#include "typical_errors.hpp"

namespace point_sampling_chapter {

Table orders_table() {
  Table table({"points or columns", "1000", "4000", "16000", "64000", "observed order", "theory"});
  for (std::size_t i = 0; i < methods().size(); ++i) {
    const Method& method = methods()[i];
    std::vector<std::string> row{method.name};
    std::vector<double> h;
    for (std::size_t k = 0; k < method.numbers.size(); ++k) {
      row.push_back(error_number(all_errors()[i][k]));
      h.push_back(1.0 / method.numbers[k]);
    }
    const double order = runge_kutta::observed_order(h, all_errors()[i]);
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), "−%.2f", order);
    row.insert(row.end(), {text.data(), method.theory});
    table.add(row);
  }
  return table;
}

std::string orders_figure() {
  support::Plot plot{"inertia of a mug",
                     {"points or columns", support::Scale::log},
                     {"error", support::Scale::log},
                     {}};
  for (std::size_t i = 0; i < methods().size(); ++i) {
    support::Series series{methods()[i].name, {}, {}};
    for (std::size_t k = 0; k < methods()[i].numbers.size(); ++k) {
      series.x.push_back(methods()[i].numbers[k]);
      series.y.push_back(all_errors()[i][k]);
    }
    plot.series.push_back(series);
  }
  return support::to_svg(plot);
}

// ── How honest the standard error is ──

namespace {

/// The true error and the reported one, of the mass, as roots of the mean squares over placements.
struct Honesty {
  double error = 0, reported = 0;
};

/// @param find find(placement, seed) gives SampledMassProperties
template <class Find>
Honesty honesty(const Find& find) {
  constexpr int count = 100;
  Honesty sums;
  Seed seed = 0;
  for (const Placement& at : placements(count)) {
    const sampling::SampledMassProperties found = find(at, 1000 * ++seed);
    sums.error += std::pow(found.mass / mug_truth().mass - 1, 2) / count;
    sums.reported += std::pow(found.mass_standard_error / mug_truth().mass, 2) / count;
  }
  return {std::sqrt(sums.error), std::sqrt(sums.reported)};
}

/// As many sets of points, and their scatter.
template <class MakePoints>
sampling::SampledMassProperties mug_by_sets(const Placement& at, int sets, Seed seed,
                                            MakePoints&& points) {
  return sampling::replicated_mass_properties(solids::placed(mug_solid(), at.R, at.x), mug_density,
                                              sets, [&](Seed set) { return points(seed + set); });
}

}  // namespace

Table honest_table() {
  Table table({"8000 points", "the true error", "the standard error says", "ratio"});
  const auto add = [&table](const std::string& name, const auto& find) {
    const Honesty h = honesty(find);
    table.add({name, percent(h.error), percent(h.reported), number(h.reported / h.error, 2)});
  };
  using At = const Placement&;
  add("random", [](At at, Seed s) { return sampled_mug(at, sampling::RandomPoints(8000, s)); });
  add("stratified",
      [](At at, Seed s) { return sampled_mug(at, sampling::StratifiedPoints(20, s)); });
  add("grid", [](At at, Seed) { return sampled_mug(at, sampling::GridPoints(20)); });
  add("R3", [](At at, Seed) { return sampled_mug(at, sampling::R3Points(8000)); });
  add("8 stratified sets", [](At at, Seed s) {
    return mug_by_sets(at, 8, s, [](Seed set) { return sampling::StratifiedPoints(10, set); });
  });
  add("8 sets of R3", [](At at, Seed s) {
    return mug_by_sets(at, 8, s, [](Seed set) { return sampling::R3Points(1000, set); });
  });
  return table;
}

}  // namespace point_sampling_chapter
