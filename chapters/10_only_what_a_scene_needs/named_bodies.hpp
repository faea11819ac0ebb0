#pragma once
/// @file
/// Bodies of daily life and what they are called.

#include "common.hpp"
#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/mass/solids/ball.hpp"
#include "tumble/mass/solids/box.hpp"
#include "tumble/mass/solids/cylinder.hpp"

namespace scene_chapter {

/// A body and what it is called.
struct Named {
  std::string name;
  RigidBody<> body;
};

inline RigidBody<> solid(const auto& shape, double density) {
  return RigidBody<>(mass_properties(shape, density));
}

inline RigidBody<> ball() { return solid(Ball{0.033}, 380); }
inline RigidBody<> coin() { return solid(Cylinder{0.0116, 0.00233}, 7500); }
inline RigidBody<> plate() { return solid(Cylinder{0.12, 0.002}, 2400); }
inline RigidBody<> pencil() { return solid(Cylinder{0.0035, 0.175}, 600); }
inline RigidBody<> die() { return solid(Box{{0.016, 0.016, 0.016}}, 1200); }

/// By its mesh of 20,000 triangles. That of the drawings has some hundred and tells moments apart
/// by a per cent or so, which is just what this chapter asks about.
inline RigidBody<> weighed_finely(const Object& object) {
  return RigidBody<>(mesh_mass_properties(object.mesh(object.fine), object.density));
}

inline const RigidBody<>& gear() {
  static const RigidBody<> body = weighed_finely(objects::all[4]);
  return body;
}
inline const RigidBody<>& racket() {
  static const RigidBody<> body = weighed_finely(objects::all[2]);
  return body;
}
inline const RigidBody<>& fine_nut() {
  static const RigidBody<> body = weighed_finely(nut_object);
  return body;
}

}  // namespace scene_chapter
