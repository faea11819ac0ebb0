#include "scenes/scene.hpp"

#include <cmath>
#include <set>

#include "scenes/find_body.hpp"
#include "scenes/read_body.hpp"
#include "scenes/read_contact.hpp"
#include "scenes/read_springs.hpp"
#include "support/parsed_json.hpp"
#include "support/text_file.hpp"
#include "tumble/core/time_span.hpp"

namespace tumble::scenes {
namespace {

using support::Place;

StopWhen read_stop(const Place& place, const std::vector<SceneBody>& bodies) {
  place.require_some({"body", "coordinate", "passes"});
  const std::size_t body = place.has("body") ? find_body(place["body"], bodies) : 0;
  const std::string coordinate = place["coordinate"].text();
  const std::size_t axis = std::string("xyz").find(coordinate);
  require(coordinate.size() == 1 && axis != std::string::npos, place.name(), ".coordinate is \"",
          coordinate, "\", not x, y or z");
  return {body, static_cast<int>(axis), place["passes"].number()};
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

void require_different_names(const Scene& scene, const Place& root) {
  std::set<std::string> names;
  const auto require_new = [&](const std::string& name, const std::string& list, std::size_t i) {
    require(names.insert(name).second, root.name(), ".", list, "[", i, "] is called \"",
            support::escaped(name), "\", and so is one before it");
  };
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    require_new(scene.bodies[i].name, "bodies", i);
  if (!scene.contact) return;
  const std::size_t floors = root.has("floor") ? 1 : 0;
  for (std::size_t i = floors; i < scene.contact->walls.size(); ++i)
    require_new(scene.contact->walls[i].name, "walls", i - floors);
}

void read_times(const Place& root, Scene& scene) {
  scene.task.t0 = root.number_or("from", 0);
  const double duration = root["duration"].number();
  require(duration >= 0, root.name(), ".duration is ", duration, ", less than 0");
  scene.task.t1 = scene.task.t0 + duration;
  require(duration == 0 || (scene.task.t1 > scene.task.t0 && detail::is_time(duration)),
          root.name(), ".duration is ", duration, " s: too short for times from ", scene.task.t0,
          " s on, which have 16 digits");
  scene.task.tolerance = root.has("tolerance") ? root["tolerance"].positive_number() : 1e-9;
  scene.every = root.number_or("record_every", duration / 100);
  constexpr double most = 1e7;
  require(duration == 0 || (scene.every > 0 && duration / scene.every <= most), root.name(),
          ".record_every is ", scene.every, "; it must be between ", duration / most,
          " s and the duration, ", duration, " s");
}

Scene interpret(const Place& root, const std::filesystem::path& folder) {
  root.require_some({"bodies", "springs", "gravity", "from", "duration", "tolerance",
                     "record_every", "stop_when", "floor", "walls", "restitution", "friction"});
  Scene scene;
  scene.gravity = root.vector_or("gravity", Vec3::Zero());
  scene.contact = read_contact(root);
  const std::vector<Place> bodies = root["bodies"].elements();
  require(!bodies.empty(), root.name(), ".bodies is empty");
  for (std::size_t i = 0; i < bodies.size(); ++i)
    scene.bodies.push_back(
        read_body(bodies[i], i, {folder, scene.gravity, scene.contact.has_value()}));
  require_different_names(scene, root);
  if (root.has("springs")) {
    require(!scene.contact, root.name(),
            ".springs: in a scene with contact (floor, walls, "
            "restitution, friction) bodies fly under gravity alone. Leave it out, or leave out "
            "contact");
    scene.springs = read_springs(root["springs"], scene.bodies);
  }
  read_times(root, scene);
  if (root.has("stop_when")) scene.stop = read_stop(root["stop_when"], scene.bodies);
  if (scene.contact) require_apart(root, scene);
  return scene;
}

}  // namespace

Scene read_scene(const std::filesystem::path& file) {
  return parse_scene(support::read_text(file), support::escaped(file.filename().string()),
                     file.parent_path());
}

Scene parse_scene(const std::string& text, const std::string& name,
                  const std::filesystem::path& folder) {
  const nlohmann::json json = support::parsed_json(text, name);
  require_numbers_of_this_world(json, name);
  return interpret(Place(json, name), folder);
}

}  // namespace tumble::scenes
