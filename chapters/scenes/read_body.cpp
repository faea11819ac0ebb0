#include "scenes/read_body.hpp"

#include <cmath>
#include <iostream>
#include <numbers>

#include "scenes/read_shape.hpp"
#include "tumble/body/forces.hpp"
#include "tumble/quaternion.hpp"

namespace tumble::scenes {
namespace {

using support::Place;

/// A tensor from xx, yy, zz or xx, yy, zz, xy, yz, zx.
Mat3 tensor(const Place& place) {
  const std::size_t count = place.elements().size();
  Eigen::Matrix<double, 6, 1> v = Eigen::Matrix<double, 6, 1>::Zero();
  if (count == 3)
    v.head<3>() = place.vector();
  else
    v = place.numbers<6>();
  Mat3 I;
  I << v[0], v[3], v[5], v[3], v[1], v[4], v[5], v[4], v[2];
  return I;
}

/// The same body at another density.
MassProperties denser(const MassProperties& body, double factor) {
  return {body.mass * factor, body.centre, body.inertia * factor};
}

/// Whether the parts of the body have densities of their own.
bool has_parts(const Place& body) { return body.has("density") && body["density"].is_object(); }

/// The densities by name, if the body has them.
parts::Densities densities_of(const Place& body) {
  parts::Densities densities;
  if (!has_parts(body)) return densities;
  const Place place = body["density"];
  for (const auto& [name, density] : place.members())
    densities.emplace(name, density.positive_number());
  require(!densities.empty(), place.name(), " is empty: give one for each part");
  return densities;
}

/// Mass, centre and inertia, from a shape or as they are given.
MassProperties mass_of(const Place& body, const std::optional<ReadShape>& shape) {
  if (!shape) {
    require(!body.has("density"), body.name(),
            " has a density, but no shape: give it a shape, or a mass and an inertia");
    require(body.has("mass") && body.has("inertia"), body.name(),
            " has no shape, so it needs a mass and an inertia: give it both, or a shape");
    return {body["mass"].positive_number(), Vec3::Zero(), tensor(body["inertia"])};
  }
  require(!body.has("inertia"), body.name(), " has a shape and an inertia: give one of them");
  require(body.has("mass") != body.has("density") || has_parts(body), body.name(),
          " needs either a mass or a density beside its shape");
  if (body.has("mass"))
    return denser(shape->unit, body["mass"].positive_number() / shape->unit.mass);
  return has_parts(body) ? shape->unit : denser(shape->unit, body["density"].positive_number());
}

Quat orientation_of(const Place& body) {
  if (!body.has("orientation")) return {1, 0, 0, 0};
  const Place place = body["orientation"];
  if (!place.is_object()) {
    const Eigen::Vector4d q = place.numbers<4>();
    require(!q.isZero(0), place.name(), " is zero");
    return from_coefficients<double>(q.stableNormalized());
  }
  place.require_some({"axis", "angle"});
  const Vec3 axis = place["axis"].vector();
  require(!axis.isZero(0), place.name(), ".axis is zero");
  const Place angle = place["angle"];
  constexpr double turn = 2 * std::numbers::pi;
  if (std::abs(angle.number()) > turn)
    std::cerr << "tumble: note: " << angle.name() << " is " << angle.number() << " rad, "
              << angle.number() / turn << " turns. " << angle.number() << " degrees would be "
              << angle.number() * turn / 360 << " rad.\n";
  return exp_quaternion<double>(angle.number() * axis.stableNormalized());
}

/// Adds a force to a body. Points count from the origin of the shape, forces from the centre.
void add_force(const Place& force, const Vec3& centre, SceneBody& body) {
  const std::string kind =
      force.only_key({"force", "drag", "spring"}, "give one of them here, and the other by itself");
  const auto point = [&](const Place& at) -> Vec3 { return at.vector() - centre; };
  if (kind == "force") {
    const Place f = force["force"];
    f.require_some({"newton", "at"});
    const ForceAtBodyPoint push{f["newton"].vector(), f.has("at") ? point(f["at"]) : Vec3(0, 0, 0)};
    body.steady = body.steady + push.steady(body.body);
  } else if (kind == "drag") {
    const Place d = force["drag"];
    d.require_some({"linear", "angular"});
    const BodyDrag drag{d.number_or("linear", 0), d.number_or("angular", 0)};
    d.refused_here([&] { drag.require_valid(); });
    body.steady = body.steady + drag.steady(body.body);
  } else {
    const Place s = force["spring"];
    s.require_some({"at", "anchor", "stiffness", "length", "damping"});
    const SpringToWorld spring{point(s["at"]), s["anchor"].vector(), s["stiffness"].number(),
                               s.number_or("length", 0), s.number_or("damping", 0)};
    s.refused_here([&] { spring.require_valid(); });
    body.springs.push_back(spring);
  }
}

/// Where the body starts and how it moves; how it turns about its point, if that is held.
RigidBodyState<> start_of(const Place& place, const RigidBody<>& body,
                          const std::optional<HeldBody>& held) {
  const Vec3 position = place.vector_or("position", Vec3::Zero());
  const Vec3 omega = place.vector_or("omega", Vec3::Zero());
  const Quat q = orientation_of(place);
  if (!held)
    return state_of_motion<double>(body, position, q, place.vector_or("velocity", Vec3::Zero()),
                                   omega);
  require(!place.has("velocity"), place.name(),
          " is held at a point, so its velocity follows from omega: leave the velocity out");
  return held->turning(position, q, omega);
}

/// With contact all flights are closed forms, under gravity alone.
void require_only_gravity(const Place& body) {
  for (const char* key : {"forces", "held_at"})
    require(!body.has(key), body.name(), ".", key,
            ": in a scene with contact (floor, walls, restitution, friction) bodies fly under "
            "gravity alone. Leave it out, or leave out contact");
  require(body.has("shape"), body.name(),
          " has no shape: in a scene with contact each body needs one, to hit others with");
}

}  // namespace

SceneBody read_body(const Place& place, std::size_t index, const Surroundings& around) {
  place.require_some({"name", "shape", "density", "mass", "inertia", "position", "orientation",
                      "velocity", "omega", "held_at", "forces"});
  if (around.contact) require_only_gravity(place);
  std::optional<ReadShape> shape;
  if (place.has("shape")) shape = read_shape(place["shape"], around.folder, densities_of(place));
  const MassProperties mass = mass_of(place, shape);
  const RigidBody<> body = place.refused_here([&] { return RigidBody<>(mass); });
  std::optional<HeldBody> held;
  if (place.has("held_at")) held.emplace(body, place["held_at"].vector() - mass.centre);
  SceneBody result{
      .name = place.has("name") ? place["name"].text() : "body " + std::to_string(index + 1),
      .body = body,
      .centre = mass.centre,
      .start = start_of(place, body, held),
      .steady = Weight{around.gravity}.steady(body),
      .springs = {},
      .held = held};
  if (shape && place["shape"].has("mesh"))
    result.mesh = mesh_path(place["shape"]["mesh"], around.folder);
  if (place.has("forces"))
    for (const Place& force : place["forces"].elements()) add_force(force, mass.centre, result);
  if (around.contact)
    result.shape = place["shape"].refused_here([&] { return body_shape(*shape); });
  return result;
}

}  // namespace tumble::scenes
