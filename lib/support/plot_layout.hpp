#pragma once
/// @file
/// Where the names of curves are: at the curve's end if there is room, else near it or in the
/// margin, with a thin leader.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "support/label_costs.hpp"
#include "support/plot_label.hpp"

namespace tumble::support::plot_detail {

/// The points of a curve, so close to each other that no name fits between two. Of one that fills
/// the frame, as it goes up and down hundreds of times, they are farther apart.
inline std::vector<Pixel> dense(const Series& series, const Frame& frame) {
  constexpr double nearest = 4, most = 20'000;
  const std::vector<std::vector<Pixel>> curve = pieces(series, frame);
  const double close = std::max(nearest, length(curve) / most);
  std::vector<Pixel> points;
  for (const std::vector<Pixel>& piece : curve)
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const Pixel to = piece[i], from = i == 0 || series.look == Look::dots ? to : piece[i - 1];
      const int n = 1 + static_cast<int>(distance(from, to) / close);
      for (int k = 1; k <= n; ++k)
        points.push_back({from.x + (to.x - from.x) * k / n, from.y + (to.y - from.y) * k / n});
    }
  return points;
}

/// Places names one after the other; each time it takes the place that costs least.
class LabelPlacer {
 public:
  LabelPlacer(const Plot& plot, const Frame& frame) : plot_(plot), frame_(frame) {
    for (const Series& series : plot.series) curves_.push_back(dense(series, frame));
  }

  /// @param price takes what the dearest place costs
  std::vector<Label> placed(double& price) {
    for (std::size_t s = 0; s < curves_.size(); ++s)
      if (!curves_[s].empty() && !plot_.series[s].name.empty())
        labels_.push_back({s, curves_[s].back(), {}});
    constexpr int rounds = 4;  // the first knows only the names before it
    for (int round = 0; round < rounds; ++round) {
      price = 0;
      for (std::size_t i = 0; i < labels_.size(); ++i)
        price = std::max(price, place(i, round == 0 ? i : labels_.size()));
    }
    return labels_;
  }

 private:
  /// A place for a name, and what it costs at least.
  struct Candidate {
    Label label;
    std::size_t number;  ///< of two that cost as much, the first is taken
    double price;
  };

  /// Moves a name to its best place. What seems cheap is tried first: most others need no look at
  /// the curves.
  /// @return what that costs
  double place(std::size_t which, std::size_t known) {
    std::vector<Candidate> list;
    for (const Label& label : candidates(labels_[which].series))
      list.push_back({label, list.size(), cost_by_itself(label, frame_)});
    std::sort(list.begin(), list.end(), [](const Candidate& a, const Candidate& b) {
      return std::pair(a.price, a.number) < std::pair(b.price, b.number);
    });
    Candidate best{labels_[which], 0, std::numeric_limits<double>::infinity()};
    for (Candidate& candidate : list) {
      if (candidate.price > best.price) break;
      add_cost_among_names(candidate, which, known, best.price);
      add_cost_among_curves(candidate, best.price);
      if (std::pair(candidate.price, candidate.number) < std::pair(best.price, best.number))
        best = candidate;
    }
    labels_[which] = best.label;
    return best.price;
  }

  /// Around the curve's end, near and farther away, and in the margin. Dots without a line have no
  /// end: each of them will do.
  std::vector<Label> candidates(std::size_t series) const {
    const bool dots = plot_.series[series].look == Look::dots;
    const std::vector<Pixel> ends =
        dots ? curves_[series] : std::vector<Pixel>{curves_[series].back()};
    const double w = text_width(plot_.series[series].name);
    std::vector<Label> list;
    for (const Pixel& end : ends) {
      add_margin(list, series, end, w);
      for (const double away : {9.0, 26.0, 46.0, 70.0, 100.0})
        for (int eighth = 0; eighth < 8; ++eighth) {
          const double angle = eighth * std::numbers::pi / 4;
          const double dx = std::cos(angle), dy = std::sin(angle);
          list.push_back({series,
                          end,
                          {end.x + away * dx + (dx - 1) / 2 * w,
                           end.y + away * dy + (dy - 1) / 2 * text_height, w, text_height}});
        }
    }
    return list;
  }

  void add_margin(std::vector<Label>& list, std::size_t series, const Pixel& end, double w) const {
    const double x = frame_.right_end() + margin_gap;
    for (int step = -50; step <= 50; ++step) {
      const double y = end.y - text_height / 2 + 5 * step;
      list.push_back({series, end, {x, y, w, text_height}});
    }
  }

  /// The same for being on other names.
  /// @param enough at more than this the candidate is out, and we look no further
  void add_cost_among_names(Candidate& candidate, std::size_t which, std::size_t known,
                            double enough) const {
    const Label& label = candidate.label;
    for (std::size_t i = 0; i < known && candidate.price <= enough; ++i) {
      if (i == which) continue;
      if (labels_[i].box.meets(label.box)) candidate.price += 1e3;
      candidate.price += 200 * crossings(label, labels_[i]) + 200 * crossings(labels_[i], label);
      if (are_swapped(label, labels_[i])) candidate.price += 40;
    }
  }

  /// The same for standing on curves, and for a leader that runs across them.
  void add_cost_among_curves(Candidate& candidate, double enough) const {
    const Label& label = candidate.label;
    const std::vector<Pixel> leader =
        label.has_leader() ? leader_points(label) : std::vector<Pixel>{};
    double cost = 0;
    for (std::size_t s = 0; s < curves_.size(); ++s)
      for (const Pixel& p : curves_[s]) {
        if (candidate.price + cost > enough) break;
        if (label.box.holds(p, half_width(plot_.series[s]))) cost += 35;
        for (const Pixel& q : leader)
          if (std::abs(p.x - q.x) + std::abs(p.y - q.y) < 4) cost += 8;
      }
    candidate.price += cost;
  }

  const Plot& plot_;
  const Frame& frame_;
  std::vector<std::vector<Pixel>> curves_;
  std::vector<Label> labels_;
};

/// A frame with its names. If all of them find a good place without a margin, the frame takes its
/// room.
struct Layout {
  Frame frame;
  std::vector<Label> labels;
};

inline Layout layout(const Plot& plot) {
  constexpr double good = 30;
  double price = 0;
  if (plot.aspect == Aspect::fill) {
    Layout wide{fitted_frame(plot, width - left - narrow_right), {}};
    wide.labels = LabelPlacer(plot, wide.frame).placed(price);
    if (price < good) return wide;
  }
  Layout narrow{fitted_frame(plot), {}};
  narrow.labels = LabelPlacer(plot, narrow.frame).placed(price);
  return narrow;
}

}  // namespace tumble::support::plot_detail
