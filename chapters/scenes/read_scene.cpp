#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <optional>
#include <set>

#include "scenes/scene.hpp"
#include "support/parsed_json.hpp"
#include "support/place.hpp"
#include "support/text_file.hpp"
#include "tumble/mass.hpp"
#include "tumble/mesh/read_mesh.hpp"

namespace tumble::scenes {
namespace {

using support::Place;

/// The mass properties of a shape at 1 kg/m³, in the shape's own coordinates.
MassProperties of_shape(const Place& shape, const std::filesystem::path& folder) {
  const std::string kind =
      shape.only_key({"ball", "box", "cylinder", "cone", "capsule", "ellipsoid", "mesh"});
  const Place place = shape[kind.c_str()];
  return place.refused_here([&]() -> MassProperties {
    if (kind == "ball") return mass_properties(Ball{place.number()}, 1);
    if (kind == "box") return mass_properties(Box{place.vector()}, 1);
    if (kind == "ellipsoid") return mass_properties(Ellipsoid{place.vector()}, 1);
    if (kind == "mesh") return mesh_mass_properties(read_mesh((folder / place.text()).string()), 1);
    place.require_only({"radius", "height"});
    const double radius = place["radius"].number(), height = place["height"].number();
    if (kind == "cylinder") return mass_properties(Cylinder{radius, height}, 1);
    if (kind == "cone") return mass_properties(Cone{radius, height}, 1);
    return mass_properties(Capsule{radius, height}, 1);
  });
}

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

/// Mass, centre and inertia, from a shape or as they are given.
MassProperties mass_of(const Place& body, const std::filesystem::path& folder) {
  if (!body.has("shape")) {
    require(!body.has("density"), body.name(), " has a density, but no shape");
    return {body["mass"].number(), Vec3::Zero(), tensor(body["inertia"])};
  }
  require(!body.has("inertia"), body.name(), " has a shape and an inertia: give one of them");
  require(body.has("mass") != body.has("density"), body.name(),
          " needs either a mass or a density beside its shape");
  const MassProperties unit = of_shape(body["shape"], folder);
  return denser(unit,
                body.has("density") ? body["density"].number() : body["mass"].number() / unit.mass);
}

Quat orientation_of(const Place& body) {
  if (!body.has("orientation")) return {1, 0, 0, 0};
  const Place place = body["orientation"];
  if (!place.is_object()) {
    const Eigen::Vector4d q = place.numbers<4>();
    require(q.norm() > 0, place.name(), " is zero");
    return from_coefficients<double>(q.normalized());
  }
  place.require_only({"axis", "angle"});
  const Vec3 axis = place["axis"].vector();
  require(axis.norm() > 0, place.name(), ".axis is zero");
  const Place angle = place["angle"];
  constexpr double turn = 2 * std::numbers::pi;
  if (std::abs(angle.number()) > turn)
    std::cerr << "tumble: note: " << angle.name() << " is " << angle.number() << " rad, "
              << angle.number() / turn << " turns. " << angle.number() << " degrees would be "
              << angle.number() * turn / 360 << " rad.\n";
  return exp_quaternion<double>(angle.number() * axis.normalized());
}

/// Adds a force to a body. Points count from the origin of the shape, forces from the centre.
void add_force(const Place& force, const Vec3& centre, SceneBody& body) {
  const std::string kind = force.only_key({"force", "drag", "spring"});
  const auto point = [&](const Place& at) -> Vec3 { return at.vector() - centre; };
  if (kind == "force") {
    const Place f = force["force"];
    f.require_only({"newton", "at"});
    const ForceAtBodyPoint push{f["newton"].vector(), f.has("at") ? point(f["at"]) : Vec3(0, 0, 0)};
    body.steady = body.steady + push.steady(body.body);
  } else if (kind == "drag") {
    const Place d = force["drag"];
    d.require_only({"linear", "angular"});
    const BodyDrag drag{d.number_or("linear", 0), d.number_or("angular", 0)};
    d.refused_here([&] { drag.require_valid(); });
    body.steady = body.steady + drag.steady(body.body);
  } else {
    const Place s = force["spring"];
    s.require_only({"at", "anchor", "stiffness", "length", "damping"});
    const SpringToWorld spring{point(s["at"]), s["anchor"].vector(), s["stiffness"].number(),
                               s.number_or("length", 0), s.number_or("damping", 0)};
    s.refused_here([&] { spring.require_valid(); });
    body.springs.push_back(spring);
  }
}

/// Where the body starts and how it moves. Of a held body, `position` is that of the point that
/// stays.
RigidBodyState<> start_of(const Place& place, const RigidBody<>& body,
                          const std::optional<HeldBody>& held) {
  const Vec3 position = place.vector_or("position", Vec3::Zero());
  const Vec3 omega = place.vector_or("omega", Vec3::Zero());
  const Quat q = orientation_of(place);
  if (!held)
    return state_of_motion<double>(body, position, q, place.vector_or("velocity", Vec3::Zero()),
                                   omega);
  require(!place.has("velocity"), place.name(),
          " is held at a point and has a velocity: it follows from omega");
  return held->state(position, q, omega);
}

SceneBody read_body(const Place& place, std::size_t index, const std::filesystem::path& folder,
                    const Vec3& gravity) {
  place.require_only({"name", "shape", "density", "mass", "inertia", "position", "orientation",
                      "velocity", "omega", "held_at", "forces"});
  const MassProperties mass = mass_of(place, folder);
  const RigidBody<> body = place.refused_here([&] { return RigidBody<>(mass); });
  std::optional<HeldBody> held;
  if (place.has("held_at")) held.emplace(body, place["held_at"].vector() - mass.centre);
  SceneBody result{
      .name = place.has("name") ? place["name"].text() : "body " + std::to_string(index + 1),
      .body = body,
      .start = start_of(place, body, held),
      .steady = Weight{gravity}.steady(body),
      .springs = {},
      .held = held};
  if (place.has("forces"))
    for (const Place& force : place["forces"].elements()) add_force(force, mass.centre, result);
  return result;
}

StopWhen read_stop(const Place& place, const std::vector<SceneBody>& bodies) {
  place.require_only({"body", "coordinate", "passes"});
  const std::string name = place.has("body") ? place["body"].text() : bodies.front().name;
  const auto found = std::find_if(bodies.begin(), bodies.end(),
                                  [&](const SceneBody& body) { return body.name == name; });
  require(found != bodies.end(), place.name(), ".body: there is no body \"", name, "\"");
  const std::string coordinate = place["coordinate"].text();
  const std::size_t axis = std::string("xyz").find(coordinate);
  require(coordinate.size() == 1 && axis != std::string::npos, place.name(), ".coordinate is \"",
          coordinate, "\", not x, y or z");
  return {static_cast<std::size_t>(found - bodies.begin()), static_cast<int>(axis),
          place["passes"].number()};
}

/// Refuses numbers beyond all that is: their squares and products would leave the range of doubles.
void require_numbers_of_this_world(const nlohmann::json& value, const std::string& name) {
  constexpr double most = 1e60;
  if (value.is_number())
    require(std::abs(value.get<double>()) <= most, name, " is ", value.dump(),
            ": no number of a scene is larger than ", most);
  if (value.is_object())
    for (const auto& [key, each] : value.items())
      require_numbers_of_this_world(each, std::string(name).append(".").append(key));
  if (value.is_array())
    for (std::size_t i = 0; i < value.size(); ++i)
      require_numbers_of_this_world(
          value[i], std::string(name).append("[").append(std::to_string(i)).append("]"));
}

void require_different_names(const std::vector<SceneBody>& bodies, const Place& list) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    require(names.insert(bodies[i].name).second, list.name(), "[", i, "] is called \"",
            bodies[i].name, "\", and so is one before it");
}

Scene interpret(const Place& root, const std::filesystem::path& folder) {
  root.require_only(
      {"bodies", "gravity", "from", "duration", "tolerance", "record_every", "stop_when"});
  Scene scene;
  const Vec3 gravity = root.vector_or("gravity", Vec3::Zero());
  const std::vector<Place> bodies = root["bodies"].elements();
  require(!bodies.empty(), root.name(), ".bodies is empty");
  for (std::size_t i = 0; i < bodies.size(); ++i)
    scene.bodies.push_back(read_body(bodies[i], i, folder, gravity));
  require_different_names(scene.bodies, root["bodies"]);
  scene.task.t0 = root.number_or("from", 0);
  const double duration = root["duration"].number();
  require(duration >= 0, root.name(), ".duration is ", duration, ", less than 0");
  scene.task.t1 = scene.task.t0 + duration;
  scene.task.tolerance = root.number_or("tolerance", 1e-9);
  require(scene.task.tolerance > 0, root.name(), ".tolerance is ", scene.task.tolerance,
          "; it must be positive");
  scene.every = root.number_or("record_every", duration / 100);
  constexpr double most = 1e7;
  require(duration == 0 || (scene.every > 0 && duration / scene.every <= most), root.name(),
          ".record_every is ", scene.every, "; it must be between ", duration / most,
          " s and the duration, ", duration, " s");
  if (root.has("stop_when")) scene.stop = read_stop(root["stop_when"], scene.bodies);
  return scene;
}

}  // namespace

Scene read_scene(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  const nlohmann::json json = support::parsed_json(support::read_text(file), name);
  require_numbers_of_this_world(json, name);
  return interpret(Place(json, name), file.parent_path());
}

}  // namespace tumble::scenes
