#pragma once
/// @file
/// What a scene file says: bodies, what pushes them, for how long and how exactly.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tumble/body/forces_between.hpp"
#include "tumble/collide/convex.hpp"
#include "tumble/simulate/held.hpp"

namespace tumble::scenes {

/// What a body is to others that it hits, and what it looks like. Both in body coordinates.
struct BodyShape {
  collide::Convex convex;
  PolygonMesh drawn;   ///< for pictures
  std::string as;      ///< what collides, in words
  double missing = 0;  ///< how far the shape reaches beyond what collides, at most [m]
};

/// A body as it starts, and what pushes it.
struct SceneBody {
  std::string name;
  RigidBody<> body;
  Vec3 centre;  ///< of mass, where points of the file are counted from the shape's origin [m]
  RigidBodyState<> start;  ///< of a held body: its turning about the point
  SteadyForces steady;
  std::vector<SpringToWorld> springs;
  std::optional<HeldBody> held = {};    ///< if a point of it stays where it is
  std::optional<BodyShape> shape = {};  ///< if the scene has contact
  std::filesystem::path mesh = {};      ///< the file of its shape, if it has one
};

/// A floor or a wall.
struct SceneWall {
  std::string name;
  collide::HalfSpace half_space;
};

/// What bodies can hit beside each other, and how they come off.
struct SceneContact {
  std::vector<SceneWall> walls;  ///< floors, too
  double restitution = 0.5, friction = 0.3;
};

/// When to stop: a coordinate of one body passes a level.
struct StopWhen {
  std::size_t body;  ///< which of the bodies
  int coordinate;    ///< 0, 1, 2 for x, y, z
  double level;      ///< [m]
};

struct Scene {
  std::vector<SceneBody> bodies;
  std::vector<SpringBetween> springs = {};  ///< that join two of them
  Vec3 gravity = Vec3::Zero();              ///< [m/s²]
  SimulationTask task;
  double every = 0;  ///< between two records [s]; 0: only the end is asked for
  std::optional<StopWhen> stop;
  std::optional<SceneContact> contact;  ///< if bodies can hit things
};

/// Reads a scene; files that it names are looked for beside it.
/// @throws std::invalid_argument that says where in the file, and what
Scene read_scene(const std::filesystem::path& file);

/// The same of a text.
/// @param name   of the file, for messages
/// @param folder where files that it names are looked for
Scene parse_scene(const std::string& text, const std::string& name,
                  const std::filesystem::path& folder);

}  // namespace tumble::scenes
