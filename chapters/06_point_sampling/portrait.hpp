#pragma once
/// @file
/// A picture of a solid that is drawn by nothing but asking whether points are inside.

#include "common.hpp"
#include "support/view.hpp"

namespace point_sampling_chapter {

/// How far towards the viewer a solid reaches in each of n × n pixels; nothing where it is not.
class DepthImage {
 public:
  /// @param R      solid to viewer
  /// @param middle of the picture, in the solid's coordinates
  /// @param half   half of what the picture has room for, also in depth
  template <solids::Solid S>
  DepthImage(const S& solid, const Mat3& R, const Vec3& middle, double half, int n)
      : n_(n), depth_(static_cast<std::size_t>(n * n), nothing), pixel_(2 * half / n) {
    for (int row = 0; row < n; ++row)
      for (int column = 0; column < n; ++column) {
        const double x = (column + 0.5 - n / 2.0) * pixel_, y = (n / 2.0 - row - 0.5) * pixel_;
        at(column, row) = first_inside(
            half, [&](double z) { return solid.contains(middle + R.transpose() * Vec3(x, y, z)); });
      }
  }

  bool hit(int column, int row) const {
    return column >= 0 && row >= 0 && column < n_ && row < n_ && at(column, row) != nothing;
  }

  /// The direction in which the surface looks, from the depths of the neighbours.
  Vec3 normal(int column, int row) const {
    const double dx = slope(column, row, 1, 0), dy = -slope(column, row, 0, 1);
    return Vec3(-dx, -dy, 1).normalized();
  }

 private:
  static constexpr double nothing = -1e300;

  /// From the front to the back in 150 steps, then by halving.
  template <class Inside>
  static double first_inside(double half, const Inside& inside) {
    constexpr int steps = 150;
    for (int i = 0; i < steps; ++i) {
      double in = half * (1 - 2 * (i + 0.5) / steps), out = in + 2 * half / steps;
      if (!inside(in)) continue;
      for (int k = 0; k < 12; ++k) {
        const double middle = (in + out) / 2;
        (inside(middle) ? in : out) = middle;
      }
      return in;
    }
    return nothing;
  }

  /// The smaller of the slopes to both sides: the other one may go over an edge.
  double slope(int column, int row, int right, int down) const {
    double least = 1e300;
    for (const int side : {1, -1}) {
      if (!hit(column + side * right, row + side * down)) continue;
      const double change = at(column + side * right, row + side * down) - at(column, row);
      if (std::abs(change) < std::abs(least)) least = side * change;
    }
    return least < 1e300 ? least / pixel_ : 0;
  }

  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(n_) +
           static_cast<std::size_t>(column);
  }
  double& at(int column, int row) { return depth_[index(column, row)]; }
  double at(int column, int row) const { return depth_[index(column, row)]; }

  int n_;
  std::vector<double> depth_;
  double pixel_;
};

/// The picture as SVG: runs of pixels of the same shade, `size` px each. Its places are counted in
/// pixels of the picture, a tenth wider than they are: no seam shows.
inline std::string shaded(const DepthImage& image, int n, const Vec2& corner, double size) {
  const Vec3 light = Vec3(-0.4, 0.55, 0.73).normalized();
  std::array<std::string, 16> paths;
  const auto shade = [&](int column, int row) {
    if (!image.hit(column, row)) return -1;
    return static_cast<int>(15 * std::max(0.0, image.normal(column, row).dot(light)));
  };
  for (int row = 0; row < n; ++row)
    for (int column = 0, end = 0; column < n; column = end) {
      const int here = shade(column, row);
      for (end = column + 1; end < n && shade(end, row) == here; ++end) {
      }
      if (here < 0) continue;
      paths[static_cast<std::size_t>(here)] += "M" + support::svg_number(column) + " " +
                                               support::svg_number(row) + "h" +
                                               support::svg_number(end - column + 0.1);
    }
  std::string svg = "<g transform=\"translate(" + support::svg_number(corner.x()) + " " +
                    support::svg_number(corner.y() + size / 2) + ") scale(" +
                    support::svg_number(size, 3) + ")\" stroke-width=\"1.1\">\n";
  for (int i = 0; i < 16; ++i)
    if (const std::string& path = paths[static_cast<std::size_t>(i)]; !path.empty())
      svg +=
          "<path d=\"" + path + "\" stroke=\"" + support::view_detail::shade_colour(i) + "\"/>\n";
  return svg + "</g>\n";
}

}  // namespace point_sampling_chapter
