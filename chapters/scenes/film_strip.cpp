#include <algorithm>

#include "scenes/film_scene.hpp"
#include "scenes/motion_output.hpp"
#include "support/printable.hpp"
#include "support/space_sketch.hpp"
#include "support/table.hpp"
#include "support/view.hpp"

namespace tumble::scenes {
namespace {

using support::Placement;
using support::Vec2;

/// What the drawing has to hold [m], as the viewer sees it.
Eigen::AlignedBox2d extent(const FilmScene& film, const Scene& scene) {
  Eigen::AlignedBox2d box;
  for (const FilmPicture& picture : film.pictures) {
    const Vec2 at = (film.view * picture.state.x).head<2>();
    const Vec2 room = Vec2::Constant(scene.bodies[picture.body].shape->convex.reach());
    box.extend(Vec2(at - room)).extend(Vec2(at + room));
  }
  for (const std::vector<Vec3>& line : film.ground)
    for (const Vec3& point : line) box.extend(Vec2((film.view * point).head<2>()));
  return box;
}

/// The drawing's size [px], and how the world lies in it.
struct Layout {
  double width = 760, height = 0;
  support::Window window{};
};

Layout layout_of(const Eigen::AlignedBox2d& box) {
  constexpr double margin = 24, words = 34, highest = 560;
  Layout layout;
  const Vec2 size = box.sizes();
  const double scale =
      std::min((layout.width - 2 * margin) / size.x(), (highest - 2 * margin - words) / size.y());
  layout.height = scale * size.y() + 2 * margin + words;
  layout.window = {layout.width / 2 - scale * box.center().x(), margin + scale * box.max().y(),
                   scale};
  return layout;
}

/// The body; what is not the end of its motion is a little transparent.
std::string drawn(const FilmPicture& picture, const Scene& scene, const FilmScene& film,
                  const support::Window& window) {
  const Vec3 centre = film.view * picture.state.x;
  const std::string mesh = support::draw_mesh(
      scene.bodies[picture.body].shape->drawn, film.view * to_matrix(picture.state.q),
      {window.x + window.scale * centre.x(), window.y - window.scale * centre.y(), window.scale});
  return picture.last ? mesh : "<g opacity=\"0.55\">\n" + mesh + "</g>\n";
}

std::string colour_of(std::size_t body) {
  return "c" + std::to_string(body % support::series_colours);
}

}  // namespace

std::string film_strip(const Scene& scene, const Motions& motions) {
  const FilmScene film = film_scene(scene, motions);
  const Eigen::AlignedBox2d box = extent(film, scene);
  const Layout layout = layout_of(box);
  support::Sketch sketch(layout.width, layout.height, "Bodies at equal times, and their paths");
  sketch.look(layout.window);
  support::SpaceSketch space(sketch, film.view);
  for (const std::vector<Vec3>& line : film.ground) space.curve(line, {"grid", 1});
  for (const FilmPicture& picture : film.pictures)
    sketch.drawing(drawn(picture, scene, film, layout.window));
  for (std::size_t i = 0; i < film.paths.size(); ++i) {
    space.curve(film.paths[i], {colour_of(i), 1.4});
    const double above = layout.window.scale * scene.bodies[i].shape->convex.reach() + 6;
    space.words(film.paths[i].front(), {0, -above}, support::escaped(scene.bodies[i].name),
                colour_of(i));
  }
  sketch.words(box.min(), {0, 30}, "a picture every " + support::number(film.between) + " s",
               "faint");
  return sketch.svg();
}

}  // namespace tumble::scenes
