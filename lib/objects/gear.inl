#pragma once

#include "objects/gear.hpp"

#include "objects/surface.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::objects {

/// Half the angle that a tooth of module 3 mm takes at radius rho.
inline double half_tooth_angle(double rho, double base) {
  const auto involute = [](double alpha) { return std::tan(alpha) - alpha; };
  return pi / (2 * gear_teeth) + involute(pi / 9) - involute(std::acos(std::min(1.0, base / rho)));
}

/// A tooth seen from above, from its root on the right over the tip to its root on the left.
inline std::vector<Eigen::Vector2d> tooth_outline(double middle, int r) {
  constexpr double module = 0.003, pitch = module * gear_teeth / 2, root = pitch - 1.25 * module,
                   tip = pitch + module;
  const double base = pitch * std::cos(pi / 9);
  std::vector<Eigen::Vector2d> points;
  const auto add = [&](double rho, double angle) {
    points.emplace_back(rho * std::cos(middle + angle), rho * std::sin(middle + angle));
  };
  const int pieces = 2 * r;
  add(root, -half_tooth_angle(base, base));
  for (int k = 0; k <= pieces; ++k) {
    const double rho = base + (tip - base) * k / pieces;
    add(rho, -half_tooth_angle(rho, base));
  }
  for (int k = 1; k < r; ++k) add(tip, half_tooth_angle(tip, base) * (2.0 * k / r - 1));
  for (int k = pieces; k >= 0; --k) {
    const double rho = base + (tip - base) * k / pieces;
    add(rho, half_tooth_angle(rho, base));
  }
  add(root, half_tooth_angle(base, base));
  return points;
}

/// The edges of one side of the gear.
struct GearSide {
  Loop outline, bore;
};

/// The side at height z, of plane polygons: the teeth, and rings of quadrilaterals down to the
/// bore. It looks up when z is positive, else down.
inline GearSide add_gear_side(PolygonMesh& mesh, double z, int r) {
  constexpr double bore = 0.008;
  const auto add_face = [&](Loop face) {
    if (z < 0) std::reverse(face.begin(), face.end());
    mesh.add_face(face);
  };
  GearSide side;
  Loop ring;  // where the teeth stand, then smaller and smaller
  for (int tooth = 0; tooth < gear_teeth; ++tooth) {
    std::vector<Vec3> points;
    for (const Eigen::Vector2d& p : tooth_outline(2 * pi * tooth / gear_teeth, r))
      points.emplace_back(p.x(), p.y(), z);
    const Loop outline = add_loop(mesh, points);
    add_face(outline);
    ring.push_back(outline.front());
    ring.push_back(outline.back());
    side.outline.insert(side.outline.end(), outline.begin(), outline.end());
  }
  for (int left = 2 * r; left > 0; --left) {
    std::vector<Vec3> points;
    const double from = std::hypot(mesh.vertex(ring[0]).x(), mesh.vertex(ring[0]).y());
    const double shrink = (from + (bore - from) / left) / from;
    for (const int v : ring)
      points.emplace_back(mesh.vertex(v).x() * shrink, mesh.vertex(v).y() * shrink, z);
    const Loop next = add_loop(mesh, points);
    for (int i = 0; i < size(ring); ++i)
      add_face({at(next, i), at(ring, i), at(ring, i + 1), at(next, i + 1)});
    ring = next;
  }
  side.bore = ring;
  return side;
}

/// The wall between two loops that lie above each other, of plane rectangles, in `pieces` bands.
inline void add_wall(PolygonMesh& mesh, const Loop& low, const Loop& high, int pieces) {
  Loop from = low;
  for (int k = 1; k <= pieces; ++k) {
    std::vector<Vec3> points;
    const double z0 = mesh.vertex(low[0]).z(), z1 = mesh.vertex(high[0]).z();
    for (const int v : low)
      points.emplace_back(mesh.vertex(v).x(), mesh.vertex(v).y(), z0 + (z1 - z0) * k / pieces);
    const Loop to = k == pieces ? high : add_loop(mesh, points);
    for (int i = 0; i < size(from); ++i)
      mesh.add_face({at(from, i), at(from, i + 1), at(to, i + 1), at(to, i)});
    from = to;
  }
}

TUMBLE_BODY PolygonMesh gear(int r) {
  require(r >= 1, "the resolution of a gear must be at least 1, not ", r);
  PolygonMesh mesh;
  const GearSide low = add_gear_side(mesh, -0.005, r), high = add_gear_side(mesh, 0.005, r);
  add_wall(mesh, low.outline, high.outline, r);
  add_wall(mesh, Loop(low.bore.rbegin(), low.bore.rend()),
           Loop(high.bore.rbegin(), high.bore.rend()), r);
  return mesh;
}

}  // namespace tumble::objects
