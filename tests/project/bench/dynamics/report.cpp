#include "project/bench/dynamics/report.hpp"

#include <map>
#include <tuple>

namespace tumble::bench {
namespace {

using support::Table;

std::string full_name(const Method& method) { return method.software + ", " + method.name; }

bool is_ours(const Curve& curve) { return curve.method->software == "tumble"; }

/// 1e-3 rather than 0.001
std::string mark_name(double mark) { return "1e" + std::to_string(std::lround(std::log10(mark))); }

std::string microseconds(double seconds) {
  return std::isinf(seconds) ? "–" : support::number(seconds * 1e6, 3);
}

/// Smaller is better: marks that are not reached, time to the finest one that is, best error.
std::tuple<int, double, double> rank(const Curve& curve) {
  int missed = 0;
  double finest = 0;
  for (const double mark : marks) {
    const double seconds = curve.seconds_to_reach(mark);
    std::isinf(seconds) ? ++missed : finest = seconds;
  }
  return {missed, finest, curve.best_error()};
}

/// The fastest at a mark, ours or not; none if nobody reaches it.
const Curve* fastest(const std::vector<Curve>& curves, double mark, bool ours) {
  const Curve* best = nullptr;
  for (const Curve& curve : curves) {
    const double seconds = curve.seconds_to_reach(mark);
    if (is_ours(curve) != ours || std::isinf(seconds)) continue;
    if (!best || seconds < best->seconds_to_reach(mark)) best = &curve;
  }
  return best;
}

/// Without the precision that it was built for.
std::string product(const Curve& curve) {
  return curve.method->software.substr(0, curve.method->software.find(" ("));
}

/// Of each software the curve with the best rank, and ours that are fastest at some mark.
std::vector<const Curve*> to_be_drawn(const std::vector<Curve>& curves) {
  std::map<std::string, const Curve*> best;
  for (const Curve& curve : curves) {
    const Curve*& so_far = best[product(curve)];
    if (!so_far || rank(curve) < rank(*so_far)) so_far = &curve;
  }
  for (const double mark : marks)
    if (const Curve* curve = fastest(curves, mark, true)) best[full_name(*curve->method)] = curve;
  std::vector<const Curve*> drawn;
  for (const Curve& curve : curves)
    if (std::any_of(best.begin(), best.end(), [&](const auto& b) { return b.second == &curve; }))
      drawn.push_back(&curve);
  return drawn;
}

/// The points that no other beats in both: time is not as steady as error.
support::Series front(const Curve& curve) {
  const std::string name = product(curve) + (is_ours(curve) ? ", " + curve.method->name : "");
  support::Series series{name, {}, {}};
  for (const Point& point : curve.points) {
    if (curve.seconds_to_reach(point.error) < point.seconds) continue;
    series.x.push_back(point.seconds);
    series.y.push_back(point.error);
  }
  return series;
}

}  // namespace

Table times_table(std::vector<Curve> curves) {
  std::stable_sort(curves.begin(), curves.end(), [](const Curve& a, const Curve& b) {
    return std::pair(!is_ours(a), rank(a)) < std::pair(!is_ours(b), rank(b));
  });
  std::vector<std::string> headings = {"method"};
  for (const double mark : marks) headings.push_back("µs to " + mark_name(mark));
  headings.push_back("best error");
  Table table(headings);
  for (const Curve& curve : curves) {
    std::vector<std::string> row = {full_name(*curve.method)};
    for (const double mark : marks) row.push_back(microseconds(curve.seconds_to_reach(mark)));
    row.push_back(curve.points.empty() ? "none" : support::error_number(curve.best_error()));
    table.add(row);
  }
  return table;
}

Table ratio_table(const std::vector<Curve>& curves) {
  Table table({"error", "ours", "µs", "best of the others", "µs", "others ÷ ours"});
  for (const double mark : marks) {
    const Curve* ours = fastest(curves, mark, true);
    const Curve* others = fastest(curves, mark, false);
    const auto name = [](const Curve* c) { return c ? full_name(*c->method) : "nobody"; };
    const auto time = [&](const Curve* c) {
      return c ? microseconds(c->seconds_to_reach(mark)) : "–";
    };
    const bool both = ours && others;
    table.add(
        {mark_name(mark), ours ? ours->method->name : "none", time(ours), name(others),
         time(others),
         both ? support::number(others->seconds_to_reach(mark) / ours->seconds_to_reach(mark), 3)
              : "–"});
  }
  return table;
}

support::Plot figure(const Problem& problem, const std::vector<Curve>& curves) {
  support::Plot plot{problem.title,
                     {"time [s]", support::Scale::log},
                     {"orientation error [rad]", support::Scale::log},
                     {}};
  for (const Curve* curve : to_be_drawn(curves)) plot.series.push_back(front(*curve));
  return plot;
}

}  // namespace tumble::bench
