#pragma once
/// @file
/// A spur gear with involute teeth: its bore along z.
///
/// Half the angle of a tooth at radius ρ: ψ(ρ) = π / 2N + inv 20° − inv α, cos α = ρ_base / ρ,
/// inv α = tan α − α. Source: Norton, "Machine Design" (5th ed.), §12.1–12.2.

#include "support/objects/surface.hpp"

namespace tumble::objects {

inline constexpr int gear_teeth = 18;

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

/// The mesh of a plane figure's outlines, stretched along z: quadrilaterals and plane polygons.
/// A gear 6 cm across and 1 cm thick; about 1,000 r triangles. @param r resolution, from 1
inline PolygonMesh gear(int r) {
  PolygonMesh mesh;
  constexpr double bore = 0.008, half_thickness = 0.005;
  std::vector<Loop> outline(2), inner(2);
  for (const int level : {0, 1}) {
    const double z = level == 0 ? -half_thickness : half_thickness;
    // A face of the front looks up; the same corners backwards, below, look down.
    const auto add_face = [&](Loop face) {
      if (level == 0) std::reverse(face.begin(), face.end());
      mesh.add_face(face);
    };
    Loop roots;  // where the teeth stand
    for (int tooth = 0; tooth < gear_teeth; ++tooth) {
      std::vector<Vec3> points;
      for (const Eigen::Vector2d& p : tooth_outline(2 * pi * tooth / gear_teeth, r))
        points.emplace_back(p.x(), p.y(), z);
      const Loop side = add_loop(mesh, points);
      add_face(side);
      roots.push_back(side.front());
      roots.push_back(side.back());
      outline[static_cast<std::size_t>(level)].insert(
          outline[static_cast<std::size_t>(level)].end(), side.begin(), side.end());
    }
    // Rings from the roots to the bore.
    for (int k = 1; k <= 2 * r; ++k) {
      std::vector<Vec3> points;
      for (const int v : roots) points.push_back(mesh.vertex(v));
      const double from = std::hypot(points[0].x(), points[0].y()),
                   to = from + (bore - from) / (2 * r + 1 - k);
      for (Vec3& p : points) p = Vec3(p.x() * to / from, p.y() * to / from, z);
      const Loop next = add_loop(mesh, points);
      for (int i = 0; i < size(roots); ++i)
        add_face({at(next, i), at(roots, i), at(roots, i + 1), at(next, i + 1)});
      roots = next;
    }
    inner[static_cast<std::size_t>(level)] = roots;
  }
  for (int i = 0; i < size(outline[0]); ++i)
    mesh.add_face(
        {at(outline[0], i), at(outline[0], i + 1), at(outline[1], i + 1), at(outline[1], i)});
  for (int i = 0; i < size(inner[0]); ++i)
    mesh.add_face({at(inner[0], i + 1), at(inner[0], i), at(inner[1], i), at(inner[1], i + 1)});
  return mesh;
}

}  // namespace tumble::objects
