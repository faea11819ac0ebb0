/// @file
/// What each way costs, in operations and in time, and the errors that are left.

#include "common.hpp"
#include "far_mug.hpp"
#include "lattice_tetrahedron.hpp"
#include "parts.hpp"
#include "support/counted.hpp"
#include "support/stopwatch.hpp"
#include "support/wrapped.hpp"
#include "tumble/mass/rounding_sums.hpp"
#include "tumble/mass/tetrahedron.hpp"

namespace tumble::simd {

/// One instruction, counted as one multiplication.
template <>
support::Counted fused_multiply_add(const support::Counted& a, const support::Counted& b,
                                    const support::Counted& c) {
  ++support::Counted::done.multiplications;
  return a.value * b.value + c.value;
}

/// Taking a sign away is neither.
template <>
support::Counted absolute(const support::Counted& x) {
  return x;
}

}  // namespace tumble::simd

namespace mirtich_chapter {

using support::Counted;

// ── Operations ──

namespace {

template <class T>
using Corners = std::array<Point<T>, 3>;

Corners<Counted> counted_corners() {
  return {Point<Counted>{1.1, 0.2, 0.3}, {0.2, 1.4, 0.1}, {0.3, 0.1, 1.7}};
}

template <simd::Fma fma>
Corners<detail::Pair<Counted, fma>> counted_pairs() {
  const auto pair = [](double x) { return detail::Pair<Counted, fma>{x, 1e-17}; };
  const auto point = [&](double x, double y, double z) -> Point<detail::Pair<Counted, fma>> {
    return {pair(x), pair(y), pair(z)};
  };
  return {point(1.1, 0.2, 0.3), point(0.2, 1.4, 0.1), point(0.3, 0.1, 1.7)};
}

/// The ten terms of a triangle, added to the sums.
template <simd::Fma fma, class T>
void add_triangle(Moments<T>& sum, const Corners<T>& t) {
  sum += detail::raw_moments<fma>(simd::six_volume<fma>(t[0], t[1], t[2]), t[0], t[1], t[2]);
}

/// What the error bounds ask for.
void add_bounds(detail::RoundingSums<Counted>& sums, const Corners<Counted>& t) {
  sums.add(t[0], t[1], t[2], t[1], t[2]);
}

}  // namespace

Table counts_table() {
  using simd::Fma;
  Table table({"a triangle", "operations"});
  const auto add = [&](const std::string& what, auto&& action) {
    table.add({what, support::text_of(support::count(action))});
  };
  const Corners<Counted> t = counted_corners();
  Moments<Counted> sum;
  detail::RoundingSums<Counted> bounds;
  add("6V from corners", [&] { support::keep(six_volume_of_corners(t[0], t[1], t[2])); });
  add("6V from edges", [&] { support::keep(six_volume_of_edges(t[0], t[1], t[2])); });
  add("all ten sums, in doubles", [&] { add_triangle<Fma::separate>(sum, t); });
  add("the error bounds", [&] { add_bounds(bounds, t); });
  Moments<detail::Pair<Counted, Fma::fused>> fused;
  add("all ten sums, in pairs",
      [&, pairs = counted_pairs<Fma::fused>()] { add_triangle<Fma::fused>(fused, pairs); });
  Moments<detail::Pair<Counted, Fma::separate>> separate;
  add("the same, without fused multiply-add", [&, pairs = counted_pairs<Fma::separate>()] {
    add_triangle<Fma::separate>(separate, pairs);
  });
  return table;
}

// ── Errors ──

namespace {

struct WayToSum {
  std::string name;
  MassProperties (*sum)(const PolygonMesh&);
};

const std::vector<WayToSum> ways_to_sum{
    {"corners, world's origin",
     [](const PolygonMesh& mesh) {
       return one_by_one<double>(mesh, Vec3::Zero(), six_volume_of_corners);
     }},
    {"edges, world's origin",
     [](const PolygonMesh& mesh) {
       return one_by_one<double>(mesh, Vec3::Zero(), six_volume_of_edges);
     }},
    {"plain loop: edges, the body", plain_loop},
    {"textbook",
     [](const PolygonMesh& mesh) -> MassProperties { return computed(mesh, Accuracy::textbook); }},
    {"fast",
     [](const PolygonMesh& mesh) -> MassProperties { return computed(mesh, Accuracy::fast); }},
    {"tight",
     [](const PolygonMesh& mesh) -> MassProperties { return computed(mesh, Accuracy::tight); }}};

}  // namespace

Table errors_table() {
  const Mat3 askew = exp_rotation(Vec3(0.5, -1.1, 0.7));
  const std::vector<PolygonMesh> bodies{objects::mug(4), mug_at(1e3), mug_at(1e8),
                                        lattice_tetrahedron(askew, {1, 1, 1e-6}).mesh,
                                        lattice_tetrahedron(askew, {1, 1e-6, 1e-6}).mesh};
  Table table({"inertia of", "a mug", "1e3 m away", "1e8 m away", "a plate", "a needle"});
  std::vector<MassProperties> truths;
  for (const PolygonMesh& body : bodies) truths.push_back(exact(body));
  for (const WayToSum& way : ways_to_sum) {
    std::vector<std::string> row{way.name};
    for (std::size_t i = 0; i < bodies.size(); ++i)
      row.push_back(while_any(inertia_error(way.sum(bodies[i]), truths[i])));
    table.add(row);
  }
  return table;
}

Table mesh_table() {
  Table table({"triangles", "mass too small by", "ratio", "moment about the axis by", "rounding"});
  const double R = ring_radius, r = tube_radius;
  const double mass = 2 * pi * pi * R * r * r, moment = mass * (R * R + 0.75 * r * r);
  double before = 0;
  for (const int k : {8, 16, 32, 64, 128, 224}) {
    const BoundedMassProperties found = computed(torus(k), Accuracy::fast);
    const double error = 1 - found.mass / mass;
    table.add({std::to_string(4 * k * k), error_number(error),
               before == 0 ? "" : number(before / error, 3) + " × less",
               error_number(1 - found.inertia(2, 2) / moment),
               error_or_rounding(found.inertia_error_bound)});
    before = error;
  }
  return table;
}

// ── Times ──

namespace {

/// What no method can be faster than: every vertex and every index, once.
double read_once(const PolygonMesh& mesh) {
  double x = 0, y = 0, z = 0;
  for (const Vec3& v : mesh.vertices) {
    x += v.x();
    y += v.y();
    z += v.z();
  }
  std::int64_t corners = 0;
  for (const int v : mesh.corners) corners += v;
  return x + y + z + static_cast<double>(corners);
}

std::vector<support::Timing> timings_on(const PolygonMesh& mesh) {
  support::Stopwatch stopwatch;
  const auto add = [&](const std::string& name, auto&& action) {
    stopwatch.add(
        name, [&mesh, action] { support::keep(action(mesh)); }, 1);
  };
  const auto sums = [&](const std::string& name, Accuracy accuracy) {
    add(name,
        [accuracy](const PolygonMesh& m) { return unchecked_mass_properties(m, 1, accuracy); });
  };
  const auto diagnosed = [&](const std::string& name, Accuracy accuracy) {
    add(name, [accuracy](const PolygonMesh& m) {
      return mesh_mass_properties(m, 1, {.accuracy = accuracy}).mass;
    });
  };
  add("every vertex and index read once", read_once);
  add("plain loop", plain_loop);
  sums("fast", Accuracy::fast);
  sums("tight", Accuracy::tight);
  sums("textbook", Accuracy::textbook);
  add("diagnosis alone", [](const PolygonMesh& m) { return diagnose(m).size(); });
  diagnosed("fast, with diagnosis", Accuracy::fast);
  diagnosed("tight, with diagnosis", Accuracy::tight);
  return stopwatch.timings();
}

}  // namespace

Table times_table() {
  const PolygonMesh mug = objects::mug(4), large = torus(224);
  const std::vector<support::Timing> on_mug = timings_on(mug), on_torus = timings_on(large);
  Table table({"a triangle of", "a mug of 20,000", "ratio", "a torus of 200,000", "ratio"});
  const auto cells = [](const PolygonMesh& mesh, const std::vector<support::Timing>& all,
                        std::size_t i) -> std::array<std::string, 2> {
    return {support::duration(all[i].seconds / mesh.face_count()),
            support::times(all[i].seconds / all[1].seconds)};
  };
  for (std::size_t i = 0; i < on_mug.size(); ++i) {
    const auto a = cells(mug, on_mug, i), b = cells(large, on_torus, i);
    table.add({on_mug[i].name, a[0], a[1], b[0], b[1]});
  }
  return table;
}

// ── Very small and very large ──

Table sizes_table() {
  Table table({"a cube of", support::padded("what the library says", 60)});
  for (const double size : {1e-110, 1e-70, 1e-40, 1e-6, 1., 1e40, 1e70}) {
    std::vector<std::string> says;
    try {
      const auto body =
          mesh_mass_properties(cube(size), 1000, {Accuracy::tight, Policy::refuse, anywhere});
      says = {"mass " + number(body.mass) + " kg, moments " + number(body.inertia(0, 0)) +
              " kg m²"};
    } catch (const std::invalid_argument& refusal) {
      const std::string what = refusal.what();  // what a NaN is called differs
      says = support::lines_of("refused: " + what.substr(0, what.find(": its trace")), 60);
    }
    std::string name = number(size) + " m";
    for (const std::string& line : says) table.add({name, support::padded(line, 60)}), name.clear();
  }
  return table;
}

}  // namespace mirtich_chapter
