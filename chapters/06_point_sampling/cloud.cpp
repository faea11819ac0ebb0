/// @file
/// The mug as it is seen by points that are thrown at its box.

#include "common.hpp"
#include "parts.hpp"
#include "point_sets.hpp"
#include "support/box_edges.hpp"

namespace point_sampling_chapter {

namespace {

/// Mug upright, seen from a little above.
Mat3 upright() {
  return axis_rotation(0, 0.42) * axis_rotation(0, -pi / 2) * axis_rotation(2, -0.5);
}

/// What the viewer sees of a place in the mug's coordinates, the middle of its box as the origin.
Vec2 seen(const Vec3& p) { return (upright() * (p - mug_solid().bounds().center())).head<2>(); }

const std::array<std::string, 5> colours{"c0", "c7", "c2", "c4", "c1"};

/// The points in five colours, by their distance from the upright axis through the centre of mass.
void draw_cloud(support::Sketch& sketch, int tried, double pixels) {
  constexpr std::array<double, 4> borders{0.022, 0.036, 0.041, 0.05};  // [m]
  std::array<std::vector<Vec2>, 5> bands;
  for (const Vec3& p : points_inside(mug_solid(), sampling::R3Points(tried))) {
    const double distance = (p - mug_truth().centre).head<2>().norm();
    const auto band = std::upper_bound(borders.begin(), borders.end(), distance) - borders.begin();
    bands[static_cast<std::size_t>(band)].push_back(seen(p));
  }
  for (std::size_t i = 0; i < bands.size(); ++i) sketch.specks(bands[i], colours[i], pixels);
}

/// Which colour is near the axis, and which is far.
void draw_key(support::Sketch& sketch) {
  sketch.look({380, 332, 1});
  sketch.words({-66, 0}, {0, 8}, "near the upright axis", "ink", "end");
  for (std::size_t i = 0; i < colours.size(); ++i)
    sketch.dot({30 * (static_cast<double>(i) - 1.5), 0}, colours[i], 7);
  sketch.words({96, 0}, {0, 8}, "far from it");
}

void draw_box(support::Sketch& sketch) {
  const Eigen::AlignedBox3d box = mug_solid().bounds();
  const Mat3 edges = box.sizes().asDiagonal();
  sketch.curves(support::box_edges(Vec3::Zero(), edges, upright()), {"faint", 0.8});
}

}  // namespace

std::string cloud_figure() {
  support::Sketch sketch(760, 350, "A mug filled with points", 22);
  draw_key(sketch);
  const std::array<int, 3> tried{1000, 4000, 16000};
  const std::array<double, 3> pixels{2.2, 1.6, 1.1};
  for (std::size_t i = 0; i < 3; ++i) {
    sketch.look({760 * (static_cast<double>(i) + 0.5) / 3, 128, 1560});
    draw_box(sketch);
    draw_cloud(sketch, tried[i], pixels[i]);
    const auto found =
        sampling::sample_mass_properties(mug_solid(), mug_density, sampling::R3Points(tried[i]));
    const double off = std::abs(found.mass / mug_truth().mass - 1);
    sketch.words({0, 0}, {0, 138}, number(tried[i], 5) + " points:", "ink", "middle");
    sketch.words({0, 0}, {0, 168}, "mass off by " + percent(off), "ink", "middle");
  }
  return sketch.svg();
}

}  // namespace point_sampling_chapter
