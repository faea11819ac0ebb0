/// @file
/// A box that is cut into cells, each cell a point.

#include "common.hpp"
#include "parts.hpp"

namespace point_sampling_chapter {

namespace {

/// A cube of 1 m whose bounds are a little too wide.
struct LooseCube : Box {
  static Eigen::AlignedBox3d bounds() { return {Vec3::Constant(-0.515), Vec3::Constant(0.515)}; }
};

/// A plank by n³ points, for each n.
Table planks(const std::vector<int>& numbers) {
  Table table({"cells", "mass", "I_zz", "missing", "1/n²"});
  const Box plank{Vec3(1, 0.2, 0.05)};
  const MassProperties truth = mass_properties(plank, 500);
  for (const int n : numbers) {
    const auto body = sampling::sample_mass_properties(plank, 500, sampling::GridPoints(n));
    table.add(
        {number(n) + "³", number(body.mass, 6) + " kg", number(body.inertia(2, 2), 6) + " kg m²",
         percent(1 - body.inertia(2, 2) / truth.inertia(2, 2), 5), percent(1.0 / (n * n), 5)});
  }
  return table;
}

}  // namespace

Table cells_table() { return planks({1, 2, 4, 8, 16}); }

Table finer_table() { return planks({32, 45}); }

Table fill_table() {
  Table table({"object", "share of its box", "error of 1000 points", "for 1 %"});
  constexpr std::array names{"T-handle", "wing nut", "tennis racket", "mug", "gear"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const PolygonMesh mesh = objects::all[i].mesh(2);
    const double f = mesh_mass_properties(mesh, 1).mass / bounds(mesh).volume();
    table.add({names[i], percent(f), percent(std::sqrt((1 - f) / (1000 * f))),
               number(10 * std::round((1 - f) / f * 1000), 6) + " points"});
  }
  return table;
}

Table loose_table() {
  Table table({"32768 points", "mass", "off by", "the standard error says"});
  const auto add = [&table](const std::string& name, auto points) {
    const sampling::SampledMassProperties body =
        sampling::sample_mass_properties(LooseCube{}, 1, points);
    table.add({name, number(body.mass, 5) + " kg", percent(std::abs(body.mass - 1)),
               percent(body.mass_standard_error)});
  };
  add("grid", sampling::GridPoints(32));
  add("random", sampling::RandomPoints(32768));
  add("stratified", sampling::StratifiedPoints(32));
  add("R3", sampling::R3Points(32768));
  return table;
}

}  // namespace point_sampling_chapter
