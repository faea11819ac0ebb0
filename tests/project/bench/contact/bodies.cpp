#include "project/bench/contact/bodies.hpp"

namespace tumble::bench {

Body ball(double radius, double mass, const Vec3& x, const Vec3& v) {
  const double moment = 0.4 * mass * radius * radius;
  return {Form::ball, Vec3::Constant(2 * radius), mass, Vec3::Constant(moment), {x, v}};
}

Body box(const Vec3& size, double mass, const Vec3& x, const Quat& q) {
  const Vec3 s = size.cwiseAbs2(), moments(s.y() + s.z(), s.z() + s.x(), s.x() + s.y());
  return {Form::box, size, mass, mass / 12 * moments, {x, Vec3::Zero(), q.normalized()}};
}

Wall plane(const Vec3& normal) { return {Vec3::Zero(), normal.normalized()}; }

std::vector<Wall> room(const Vec3& size) {
  std::vector<Wall> walls;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {-1, 1})
      if (size[axis] > 0)
        walls.push_back({side * size[axis] / 2 * Vec3::Unit(axis), -side * Vec3::Unit(axis)});
  return walls;
}

}  // namespace tumble::bench
