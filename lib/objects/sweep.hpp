#pragma once
/// @file
/// A tube whose section changes on its way: handles, wings, stems.

#include <vector>

#include "objects/surface.hpp"

namespace tumble::objects {

/// A place on the way of a tube.
struct Station {
  Vec3 centre;   ///< [m]
  double half1;  ///< half the section's size along the fixed direction e1 [m]
  double half2;  ///< half its size across [m]
};

/// A section between square (0) and round (1), in the directions (c, s) of the unit circle.
inline Eigen::Vector2d section_point(double c, double s, double roundness) {
  const double to_square = 1 / std::max(std::abs(c), std::abs(s));
  return Eigen::Vector2d(c, s) * (roundness + (1 - roundness) * to_square);
}

/// The point of a curve through the stations (Catmull & Rom, 1974), t from 0 to the last one.
inline Station between(const std::vector<Station>& stations, double t) {
  const int last = static_cast<int>(stations.size()) - 1,
            i = std::min(static_cast<int>(t), last - 1);
  const double u = t - i;
  const auto station = [&](int k) -> const Station& {
    return stations[static_cast<std::size_t>(std::clamp(k, 0, last))];
  };
  const Station &a = station(i - 1), &b = station(i), &c = station(i + 1), &d = station(i + 2);
  const auto mix = [u](double p, double q, double r, double s) {
    return q + 0.5 * u * (r - p + u * (2 * p - 5 * q + 4 * r - s + u * (3 * q - p - 3 * r + s)));
  };
  Station here{Vec3::Zero(), mix(a.half1, b.half1, c.half1, d.half1),
               mix(a.half2, b.half2, c.half2, d.half2)};
  for (int k = 0; k < 3; ++k)
    here.centre[k] = mix(a.centre[k], b.centre[k], c.centre[k], d.centre[k]);
  return here;
}

/// A tube from the rim of a patch of n × m cells along the stations, `pieces` from each
/// to the next.
/// @param e1 the direction in which a section does not turn, that of the patch's loops
/// @return the last loop
inline Loop sweep(PolygonMesh& mesh, const Loop& start, int n, int m,
                  const std::vector<Station>& stations, const Vec3& e1, double roundness,
                  int pieces) {
  Loop loop = start;
  const int count = (static_cast<int>(stations.size()) - 1) * pieces;
  for (int k = 0; k <= count; ++k) {
    const double t = static_cast<double>(k) / pieces, h = 1e-3;
    const Station here = between(stations, t);
    const double top = static_cast<double>(stations.size()) - 1;
    const Vec3 ahead = (between(stations, std::min(t + h, top)).centre -
                        between(stations, std::max(t - h, 0.0)).centre)
                           .normalized();
    const Vec3 e2 = ahead.cross(e1);
    std::vector<Vec3> points;
    for (const auto& [i, j] : rim_steps(n, m)) {
      // The rim as a square, its points in the directions (c, s).
      const Eigen::Vector2d d = Eigen::Vector2d(2.0 * i / n - 1, 2.0 * j / m - 1).normalized();
      const Eigen::Vector2d p = section_point(d.x(), d.y(), roundness);
      points.push_back(here.centre + here.half1 * p.x() * e1 + here.half2 * p.y() * e2);
    }
    const Loop next = add_loop(mesh, points);
    join(mesh, loop, next);
    loop = next;
  }
  return loop;
}

}  // namespace tumble::objects
