#include "scenes/film_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/sphere_curves.hpp"

namespace tumble::scenes {
namespace {

/// When nothing moves any more, the film is over.
double end_of_film(const Motions& motions) {
  return motions.contacts ? std::min(motions.end, motions.start + motions.contacts->run.t)
                          : motions.end;
}

/// Equal times, and the first impacts, so that each bend of a path is there [s].
std::vector<double> times_of_path(const Motions& motions, std::size_t body, double end) {
  constexpr int parts = 240;
  constexpr std::size_t bends = 240;
  std::vector<double> times;
  for (int i = 0; i <= parts; ++i)
    times.push_back(motions.start + (end - motions.start) * i / parts);
  if (!motions.contacts) return times;
  const auto& flights = motions.contacts->run.flights[body];
  for (std::size_t i = 0; i < std::min(bends, flights.size()); ++i)
    times.push_back(std::min(end, motions.start + flights[i].t));
  std::sort(times.begin(), times.end());
  return times;
}

/// The horizontal direction of the longest way, as an angle about z.
double main_direction(const std::vector<std::vector<Vec3>>& paths) {
  Vec3 longest = Vec3::UnitX();
  double most = 0;
  for (const std::vector<Vec3>& path : paths)
    for (const Vec3& point : path) {
      const Vec3 way(point.x() - path.front().x(), point.y() - path.front().y(), 0);
      if (way.norm() > most) {
        most = way.norm();
        longest = way;
      }
    }
  return std::atan2(longest.y(), longest.x());
}

/// Lines on a plane under all bodies, along `along` and across.
std::vector<std::vector<Vec3>> lines_on(const collide::HalfSpace& plane, const Vec3& along,
                                        const Scene& scene,
                                        const std::vector<FilmPicture>& pictures) {
  const Vec3& n = plane.normal;
  const Vec3 flat = along - along.dot(n) * n;
  const Vec3 u = flat.norm() > 0.1 ? flat.normalized() : Vec3(n.unitOrthogonal()), v = n.cross(u);
  Eigen::AlignedBox2d box;
  for (const FilmPicture& picture : pictures) {
    const Eigen::Vector2d at(u.dot(picture.state.x), v.dot(picture.state.x));
    const Eigen::Vector2d room =
        1.2 * Eigen::Vector2d::Constant(scene.bodies[picture.body].shape->convex.reach());
    box.extend(Eigen::Vector2d(at - room)).extend(Eigen::Vector2d(at + room));
  }
  const auto point = [&](const Eigen::Vector2d& at) -> Vec3 {
    return at.x() * u + at.y() * v + n.dot(plane.point) * n;
  };
  constexpr double squares = 5;  // of the shorter side
  const double square = box.sizes().minCoeff() / squares;
  std::vector<std::vector<Vec3>> lines;
  for (int k = 0; k < 2; ++k) {
    const int count = static_cast<int>(std::min(40., std::round(box.sizes()[k] / square)));
    for (int i = 0; i <= count; ++i) {
      Eigen::Vector2d from = box.min(), to = box.max();
      from[k] = to[k] = box.min()[k] + box.sizes()[k] * i / count;
      lines.push_back({point(from), point(to)});
    }
  }
  return lines;
}

/// Floors, and what was hit: a wall that nothing comes near is not drawn.
bool is_drawn(const Scene& scene, const Motions& motions, std::size_t wall) {
  if (scene.contact->walls[wall].half_space.normal.z() > 0.7) return true;
  if (!motions.contacts) return false;
  const auto& impacts = motions.contacts->run.impacts;
  return std::any_of(impacts.begin(), impacts.end(), [&](const contact::ImpactEvent& impact) {
    return impact.wall == static_cast<int>(wall);
  });
}

std::vector<FilmPicture> take_pictures(const Scene& scene, const Motions& motions, double end) {
  const int bodies = static_cast<int>(scene.bodies.size());
  const int gaps = std::clamp(30 / bodies, 1, 11);
  std::vector<FilmPicture> pictures;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    for (int k = 0; k <= gaps; ++k)
      pictures.push_back(
          {i, motions.at(i, motions.start + (end - motions.start) * k / gaps), k == gaps});
  return pictures;
}

}  // namespace

FilmScene film_scene(const Scene& scene, const Motions& motions) {
  constexpr double degree = std::numbers::pi / 180;
  const double end = end_of_film(motions);
  FilmScene film{take_pictures(scene, motions, end), {}, {}, Mat3::Identity(), 0};
  film.between = (end - motions.start) * static_cast<double>(scene.bodies.size()) /
                 static_cast<double>(film.pictures.size() - scene.bodies.size());
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    film.paths.emplace_back();
    for (const double t : times_of_path(motions, i, end))
      film.paths.back().push_back(motions.at(i, t).x);
  }
  const double along = main_direction(film.paths);
  film.view = support::view_from(along - 76 * degree, 20 * degree);
  for (std::size_t w = 0; w < scene.contact->walls.size(); ++w)
    if (is_drawn(scene, motions, w))
      for (auto& line : lines_on(scene.contact->walls[w].half_space,
                                 {std::cos(along), std::sin(along), 0}, scene, film.pictures))
        film.ground.push_back(std::move(line));
  std::stable_sort(film.pictures.begin(), film.pictures.end(), [&](const auto& a, const auto& b) {
    return film.view.row(2).dot(a.state.x) < film.view.row(2).dot(b.state.x);
  });
  return film;
}

}  // namespace tumble::scenes
