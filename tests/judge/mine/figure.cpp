#include <algorithm>
#include <array>
#include <cmath>

#include "judge/mine/report.hpp"
#include "support/plot.hpp"

namespace tumble::judge::mine {

namespace {

using support::Look;
using support::Scale;

support::Series series_of(const Curve& curve, const std::string& owner) {
  support::Series series{owner + " " + curve.name, {}, {}};
  series.look = curve.own ? Look::line : Look::dashed;
  if (curve.own) series.width = 3.4;
  for (const Point& point : curve.points) {
    series.x.push_back(point.seconds);
    series.y.push_back(point.error);
  }
  return series;
}

support::Plot plot_of(const EngineBuild& build, const ProblemResult& result) {
  support::Plot plot{result.problem.title,
                     {"time [s]", Scale::log},
                     {"error of the orientation at the end [rad]", Scale::log},
                     {}};
  for (const Curve& curve : result.library) plot.series.push_back(series_of(curve, "library"));
  for (const OwnCurve& own : result.own)  // in front
    plot.series.push_back(series_of(own.curve, owner_of(build, number_of(own.method))));
  if (result.closed_form)
    plot.series.push_back(series_of(*result.closed_form, owner_of(build, closed_form_unit)));
  return plot;
}

/// Whether nothing of the die is the solutions'.
bool all_own(const EngineBuild& build) {
  constexpr std::array units = {"10.2", "11.2", "11.3", "11.4", "11.5"};
  return std::all_of(units.begin(), units.end(),
                     [&](const char* number) { return owner_of(build, number) == "your"; });
}

/// How late the impacts come, and how far an error of the tolerance has grown until then.
support::Plot plot_of(const EngineBuild& build, const DieResult& die) {
  support::Plot plot{"a die on a table, without friction",
                     {"impact", Scale::linear},
                     {"error of its time [s]", Scale::log},
                     {}};
  support::Series grown{"error of the tolerance", {}, {}, Look::dashed},
      own{all_own(build) ? "your die" : "die, in part yours", {}, {}};
  own.width = 3.4;
  for (std::size_t i = 0; i < die.common(); ++i) {
    const double impact = static_cast<double>(i) + 1;
    grown.x.push_back(impact);
    grown.y.push_back(die.truth.impacts[i].grown);
    own.x.push_back(impact);
    own.y.push_back(std::abs(die.late(i)));
  }
  plot.series = {grown, own};
  return plot;
}

/// "4.1 product, 4.8 …" in lines that fit below the plots.
std::vector<std::string> lines_of(const std::string& start, const std::string& names) {
  constexpr std::size_t widest = 105;
  std::vector<std::string> lines{start};
  for (std::size_t from = 0; from < names.size();) {
    const std::size_t comma = names.find(", ", from);
    const std::size_t next = comma == std::string::npos ? names.size() : comma + 2;
    const std::string name = names.substr(from, next - from);
    if (lines.back().size() + name.size() > widest) lines.emplace_back();
    lines.back() += name;
    from = next;
  }
  return lines;
}

}  // namespace

std::string figure_of(const EngineBuild& build, const Measurement& measurement) {
  std::vector<support::Plot> plots;
  for (const ProblemResult& result : measurement.problems) plots.push_back(plot_of(build, result));
  if (measurement.die && measurement.die->common() > 0)
    plots.push_back(plot_of(build, *measurement.die));
  const std::vector<Part> missing = build.missing();
  std::vector<std::string> notes =
      missing.empty() ? std::vector<std::string>{"All functions of this engine are yours."}
                      : lines_of("Not yours, but from the solutions: ", names_of(missing));
  notes.emplace_back(
      "Times are the judge's. Your code is compiled as the judge does it, for a quick "
      "answer; the library for speed.");
  return support::to_svg("your own engine beside the library", plots, notes);
}

}  // namespace tumble::judge::mine
