#include "project/bench/report.hpp"

#include <map>
#include <tuple>

namespace tumble::bench {
namespace {

using support::Table;

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
    if (curve.is_ours() != ours || std::isinf(seconds)) continue;
    if (!best || seconds < best->seconds_to_reach(mark)) best = &curve;
  }
  return best;
}

/// Without the precision that it was built for.
std::string product(const Curve& curve) {
  return curve.software.substr(0, curve.software.find(" ("));
}

/// Of each software the curve with the best rank, and ours that are fastest at some mark.
std::vector<const Curve*> to_be_drawn(const std::vector<Curve>& curves) {
  std::map<std::string, const Curve*> best;
  for (const Curve& curve : curves) {
    const Curve*& so_far = best[product(curve)];
    if (!so_far || rank(curve) < rank(*so_far)) so_far = &curve;
  }
  for (const double mark : marks)
    if (const Curve* curve = fastest(curves, mark, true)) best[curve->full_name()] = curve;
  std::vector<const Curve*> drawn;
  for (const Curve& curve : curves)
    if (std::any_of(best.begin(), best.end(), [&](const auto& b) { return b.second == &curve; }))
      drawn.push_back(&curve);
  return drawn;
}

/// The points that no other beats in both: time is not as steady as error.
support::Series front(const Curve& curve) {
  const std::string name = product(curve) + (curve.is_ours() ? ", " + curve.name : "");
  support::Series series{name, {}, {}};
  for (const Point& point : curve.points) {
    if (curve.seconds_to_reach(point.error) < point.seconds) continue;
    series.x.push_back(point.seconds);
    series.y.push_back(std::max(point.error, 0x1p-53));  // what is exact, too
  }
  return series;
}

}  // namespace

Table times_table(std::vector<Curve> curves) {
  std::stable_sort(curves.begin(), curves.end(), [](const Curve& a, const Curve& b) {
    return std::pair(!a.is_ours(), rank(a)) < std::pair(!b.is_ours(), rank(b));
  });
  std::vector<std::string> headings = {"method"};
  for (const double mark : marks) headings.push_back("µs to " + mark_name(mark));
  headings.insert(headings.end(), {"best error", "µs for it", "with"});
  Table table(headings);
  for (const Curve& curve : curves) {
    std::vector<std::string> row = {curve.full_name()};
    for (const double mark : marks) row.push_back(microseconds(curve.seconds_to_reach(mark)));
    const bool any = !curve.points.empty();
    row.push_back(any ? support::error_number(curve.best_error()) : "none");
    row.push_back(any ? microseconds(curve.points.back().seconds) : "–");
    row.push_back(setting_name(curve));
    table.add(row);
  }
  return table;
}

std::string setting_name(const Curve& curve) {
  if (curve.points.empty()) return "–";
  const double setting = curve.points.back().setting;
  return curve.knob == Knob::tolerance ? support::error_number(setting)
                                       : support::number(setting, 7) + " steps";
}

Table ratio_table(const std::vector<Curve>& curves) {
  Table table({"error", "ours", "µs", "best of the others", "µs", "others ÷ ours"});
  for (const double mark : marks) {
    const Curve* ours = fastest(curves, mark, true);
    const Curve* others = fastest(curves, mark, false);
    const auto name = [](const Curve* c) { return c ? c->full_name() : "nobody"; };
    const auto time = [&](const Curve* c) {
      return c ? microseconds(c->seconds_to_reach(mark)) : "–";
    };
    const bool both = ours && others;
    table.add(
        {mark_name(mark), ours ? ours->name : "none", time(ours), name(others), time(others),
         both ? support::number(others->seconds_to_reach(mark) / ours->seconds_to_reach(mark), 3)
              : "–"});
  }
  return table;
}

support::Plot figure(const std::string& title, const std::string& error,
                     const std::vector<Curve>& curves) {
  support::Plot plot{title, {"time [s]", support::Scale::log}, {error, support::Scale::log}, {}};
  for (const Curve* curve : to_be_drawn(curves)) plot.series.push_back(front(*curve));
  return plot;
}

}  // namespace tumble::bench
