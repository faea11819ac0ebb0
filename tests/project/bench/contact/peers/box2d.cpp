// Box2D, which computes in floats: planar scenes. No threshold for restitution, nobody sleeps,
// bodies are told to be bullets, so that they never pass through each other.
#include <box2d/box2d.h>

#include <array>

#include "project/bench/contact/contest.hpp"

namespace tumble::bench {
namespace {

/// x and z of the world are x and y of Box2D. Its angles turn x to y: about −y of the world.
b2Vec2 vector(const Vec3& v) { return {static_cast<float>(v.x()), static_cast<float>(v.z())}; }
Vec3 vector(const b2Vec2& v) { return {v.x, 0, v.y}; }

class World {
 public:
  World(const Scene& scene, double h) : h_(static_cast<float>(h)), world_(vector(scene.gravity)) {
    world_.SetAllowSleeping(false);
    for (const Wall& wall : scene.walls) add(wall, scene);
    for (const Body& body : scene.bodies) add(body, scene);
  }
  World(const World&) = delete;

  void advance(int steps) {
    for (int i = 0; i < steps; ++i) world_.Step(h_, 20, 10);
  }
  Motion motion(std::size_t i) const {
    const b2Body& body = *bodies_[i];
    const Quat turned(Eigen::AngleAxisd(-body.GetAngle(), Vec3::UnitY()));
    return {vector(body.GetPosition()), vector(body.GetLinearVelocity()), turned * starts_[i],
            -body.GetAngularVelocity() * Vec3::UnitY()};
  }

 private:
  static b2FixtureDef surface(const b2Shape& shape, const Scene& scene) {
    b2FixtureDef definition;
    definition.shape = &shape;
    definition.density = 1;
    definition.restitution = static_cast<float>(scene.e);
    definition.restitutionThreshold = 0;
    definition.friction = static_cast<float>(scene.mu);
    return definition;
  }

  /// Edges and polygons have a skin, which is what touches: the wall steps back by it.
  void add(const Wall& wall, const Scene& scene) {
    constexpr double half = 10;  // [m]: longer than any of the scenes
    const double skins = scene.bodies[0].form == Form::ball ? 1 : 2;
    const Vec3 middle = wall.point - skins * b2_polygonRadius * wall.normal;
    const Vec3 along = half * wall.normal.cross(Vec3::UnitY());
    b2EdgeShape edge;
    edge.SetTwoSided(vector(Vec3(middle - along)), vector(Vec3(middle + along)));
    const b2BodyDef fixed;
    const b2FixtureDef definition = surface(edge, scene);
    world_.CreateBody(&fixed)->CreateFixture(&definition);
  }
  void add(const Body& body, const Scene& scene) {
    b2BodyDef definition;
    definition.type = b2_dynamicBody;
    definition.bullet = true;
    definition.position = vector(body.start.x);
    definition.linearVelocity = vector(body.start.v);
    definition.angularVelocity = static_cast<float>(-body.start.omega.y());
    b2Body* const made = world_.CreateBody(&definition);
    add_shape(*made, body, scene);
    const Mat3 R = body.start.q.toRotationMatrix();
    const double moment = (R * body.moments.asDiagonal() * R.transpose())(1, 1);
    const b2MassData mass{static_cast<float>(body.mass), {0, 0}, static_cast<float>(moment)};
    made->SetMassData(&mass);
    bodies_.push_back(made);
    starts_.push_back(body.start.q);
  }
  static void add_shape(b2Body& made, const Body& body, const Scene& scene) {
    if (body.form == Form::ball) {
      b2CircleShape circle;
      circle.m_radius = static_cast<float>(body.radius());
      const b2FixtureDef definition = surface(circle, scene);
      made.CreateFixture(&definition);
      return;
    }
    std::array<b2Vec2, 8> corners;  // as the box is seen along y
    for (int i = 0; i < 8; ++i)
      corners[static_cast<std::size_t>(i)] = vector(Vec3(body.start.q * body.corner(i)));
    b2PolygonShape polygon;
    polygon.Set(corners.data(), 8);
    const b2FixtureDef definition = surface(polygon, scene);
    made.CreateFixture(&definition);
  }

  float h_;
  b2World world_;
  std::vector<b2Body*> bodies_;
  std::vector<Quat> starts_;
};

}  // namespace
}  // namespace tumble::bench

extern "C" void tumble_add_peer(std::vector<tumble::bench::Stepper>& steppers) {
  using namespace tumble::bench;
  const auto make = [](const Scene& scene, double h) -> std::unique_ptr<Simulation> {
    if (!scene.planar) return nullptr;
    return std::make_unique<Fresh<World>>([scene, h] { return std::make_unique<World>(scene, h); });
  };
  steppers.push_back({"Box2D (float)", "continuous", make});
}
