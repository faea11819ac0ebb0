/// @file
/// The mug in a row of pictures: two turns in both orders, and a turn that nobody repairs.

#include "objects/plain_mug.hpp"
#include "parts.hpp"
#include "steady_turn.hpp"
#include "support/facets.hpp"

namespace rotation_matrices_chapter {

namespace {

struct Picture {
  Mat3 R;               // body → world; a drifted one shears the picture
  std::string caption;  // one line below
};

/// Each picture has the world's axes in its lower left corner.
/// @param size what a picture has room for [m]
std::string row_of_mugs(const std::string& title, double size,
                        const std::vector<Picture>& pictures) {
  constexpr double width = 760, caption_room = 62;
  const double cell = width / static_cast<double>(pictures.size()), scale = cell / size;
  const PolygonMesh mug = objects::plain_mug();
  support::Sketch sketch(width, cell + caption_room, title, 16);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const double x = cell * (static_cast<double>(i) + 0.5);
    const Mat3 R = front_view() * pictures[i].R;
    const Vec3 middle = R * Vec3(0, 0, 0.0475);
    sketch.drawing(support::draw_facets(
        mug, R, {x - scale * middle.x(), cell / 2 + 4 + scale * middle.y(), scale}));
    sketch.look({x - cell / 2 + 24, cell + 18, 1});
    support::SpaceSketch(sketch, front_view()).world_axes(Vec3::Zero(), 26);
    sketch.look({x, cell + caption_room, 1});
    sketch.words({0, 0}, {0, -10}, pictures[i].caption, "ink", "middle");
  }
  return sketch.svg();
}

}  // namespace

std::string order_figure() {
  const Mat3 start = axis_rotation(2, 180 * degree);  // the handle to the left
  const Mat3 about_x = axis_rotation(0, 90 * degree), about_z = axis_rotation(2, 90 * degree);
  return row_of_mugs("a quarter turn about x and one about z, in both orders", 0.17,
                     {{start, "at the start"},
                      {about_x * start, "about x"},
                      {about_z * about_x * start, "about x, then z"},
                      {about_x * about_z * start, "about z, then x"}});
}

std::string sheared_figure() {
  std::vector<Picture> pictures;
  for (const int seconds : {0, 10, 20, 30}) {
    const Mat3 R = euler_turned(60 * seconds);
    pictures.push_back({R, number(seconds) + " s: volume × " + number(R.determinant(), 3)});
  }
  return row_of_mugs("Euler steps of Ṙ = [ω]×R, nothing repaired", 0.4, pictures);
}

}  // namespace rotation_matrices_chapter
