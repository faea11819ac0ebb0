#pragma once
/// @file
/// What all parts of this chapter's program share: the objects and their truth, the boxes, errors.

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "askew_box.hpp"
#include "objects/objects.hpp"
#include "support/random.hpp"
#include "support/sketch.hpp"
#include "support/table.hpp"
#include "tumble/mass.hpp"
#include "tumble/mesh.hpp"
#include "tumble/rotation.hpp"

namespace bounding_boxes_chapter {

using namespace tumble;
using support::number;
using support::Random;
using support::svg_number;
using support::Table;
using support::Vec2;

// ── The objects ──

struct Thing {
  std::string name;
  double density;  // [kg/m³]
  PolygonMesh mesh;
  MassProperties truth;  // exact, by the method of chapter 8

  double volume() const { return truth.mass / density; }
  const Points& points() const { return mesh.vertices; }
};

inline Thing thing(const std::string& name, const objects::Object& object, int resolution) {
  const PolygonMesh mesh = object.mesh(resolution);
  return {name, object.density, mesh, mesh_mass_properties(mesh, object.density)};
}

inline const std::vector<Thing>& things() {
  static const std::vector<Thing> list = [] {
    constexpr std::array names{"T-handle", "wing nut", "tennis racket", "mug", "gear"};
    std::vector<Thing> all;
    for (std::size_t i = 0; i < names.size(); ++i)
      all.push_back(thing(names[i], objects::all[i], objects::all[i].for_drawings));
    return all;
  }();
  return list;
}
inline const Thing& t_handle() { return things()[0]; }
inline const Thing& wing_nut() { return things()[1]; }
inline const Thing& racket() { return things()[2]; }
inline const Thing& mug() { return things()[3]; }

// ── Orientations that have nothing to do with the axes, the same in every run ──

inline const std::vector<Mat3>& turns() {
  static const std::vector<Mat3> list = [] {
    Random random(7);
    std::vector<Mat3> all;
    for (int i = 0; i < 16; ++i) all.push_back(exp_rotation(random.vector(pi)));
    return all;
  }();
  return list;
}

// ── Boxes ──

/// The box, full of mass at the density of the body.
inline MassProperties at_density(const boxes::OrientedBox& box, const Thing& body) {
  return boxes::box_mass_properties(box, body.density * box.volume());
}
/// The box with the mass of the body in it.
inline MassProperties at_true_mass(const boxes::OrientedBox& box, const Thing& body) {
  return boxes::box_mass_properties(box, body.truth.mass);
}
/// The box shrunk until its volume is the body's.
inline MassProperties at_true_volume(const boxes::OrientedBox& box, const Thing& body) {
  return boxes::box_mass_properties(boxes::shrunk_to(box, body.volume()), body.truth.mass);
}

/// Relative, by the root of the sum of the squares of all nine numbers.
inline double inertia_error(const Mat3& I, const Mat3& truth) {
  return (I - truth).norm() / truth.norm();
}

/// 530 %, 36 %, 4.5 %
inline std::string percent(double share) {
  return svg_number(100 * share, std::abs(share) < 0.0995 ? 1 : 0) + " %";
}

/// 4.65 ×
inline std::string times(double factor) {
  return (factor < 99.5 ? number(factor, 3) : svg_number(factor, 0)) + " ×";
}

inline std::string millimetres(const Vec3& v) {
  return svg_number(1000 * v.x(), 0) + " × " + svg_number(1000 * v.y(), 0) + " × " +
         svg_number(1000 * v.z(), 0) + " mm";
}

}  // namespace bounding_boxes_chapter
