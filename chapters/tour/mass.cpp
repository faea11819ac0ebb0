// Mass properties by boxes, points and integrals: what an error costs, and what a smaller one does.
#include <iostream>

#include "support/plot.hpp"
#include "support/stopwatch.hpp"
#include "tour/tour.hpp"
#include "tumble/mesh/mesh_solid.hpp"

namespace tumble::tour {
namespace {

using support::Table;

/// One way to compute mass properties, what it took and how wrong it is.
struct Measurement {
  std::string method;
  double seconds;
  double mass_error;     ///< relative
  double centre_error;   ///< in diagonals of the bounding box
  double inertia_error;  ///< relative, Frobenius norm
};

class Measurements {
 public:
  explicit Measurements(const Subject& subject) : subject_(subject) {}

  template <class Method>
  const Measurement& measure(const std::string& name, Method&& method) {
    constexpr double budget =
        0.02;  // seconds to repeat a fast method in, for the least of its times
    MassProperties found;
    const double seconds = support::shortest_run(budget, [&] { found = method(); });
    const MassProperties& exact = subject_.exact;
    list_.push_back({name, seconds, std::abs(found.mass / exact.mass - 1),
                     (found.centre - exact.centre).norm() / bounds(subject_.mesh).diagonal().norm(),
                     (found.inertia - exact.inertia).norm() / exact.inertia.norm()});
    return list_.back();
  }

  Table table() const {
    Table table({"method", "mass error", "centre error", "inertia error", "time"});
    for (const Measurement& m : list_)
      table.add({m.method, support::error_number(m.mass_error),
                 support::error_number(m.centre_error), support::error_number(m.inertia_error),
                 support::duration(m.seconds)});
    return table;
  }

 private:
  const Subject& subject_;
  std::vector<Measurement> list_;
};

/// A curve of the figure: error of the inertia against time. An exact 0 is shown as one rounding.
void extend(support::Series& series, const Measurement& m) {
  series.x.push_back(m.seconds);
  series.y.push_back(std::max(m.inertia_error, 0x1p-53));
}

void measure_boxes(const Subject& subject, Measurements& all, support::Plot& plot) {
  const PolygonMesh& mesh = subject.mesh;
  const double mass = subject.exact.mass, volume = mass / subject.density;
  const auto point = [&](const std::string& name, auto&& method) {
    support::Series series{name, {}, {}};
    extend(series, all.measure(name, method));
    plot.series.push_back(series);
  };
  point("box along the axes",
        [&] { return boxes::box_mass_properties(boxes::aligned_box(mesh.vertices), mass); });
  point("oriented box",
        [&] { return boxes::box_mass_properties(boxes::small_oriented_box(mesh.vertices), mass); });
  point("box of the true volume", [&] {
    return boxes::box_mass_properties(boxes::shrunk_to(boxes::aligned_box(mesh.vertices), volume),
                                      mass);
  });
}

void measure_points(const Subject& subject, Measurements& all, support::Plot& plot) {
  const MeshSolid solid(subject.mesh);
  const auto row = [&](support::Series& series, const std::string& name, auto points) {
    progress("sampling " + std::to_string(points.count()) + " points: " + series.name);
    extend(series, all.measure(name, [&] {
      return sampling::sample_mass_properties(solid, subject.density, points);
    }));
  };
  support::Series grid{"grid points", {}, {}}, random{"random points", {}, {}},
      r3{"R3 points", {}, {}};
  for (const int n : {10, 22, 46, 100}) {
    const std::int64_t count = std::int64_t{n} * n * n;
    const std::string points = std::to_string(count) + " points, ";
    row(grid, points + "grid", sampling::GridPoints(n));
    row(random, points + "random", sampling::RandomPoints(count));
    row(r3, points + "low-discrepancy R3", sampling::R3Points(count));
  }
  plot.series.insert(plot.series.end(), {grid, random, r3});
}

void measure_integrals(const Subject& subject, Measurements& all, support::Plot& plot) {
  const PolygonMesh& mesh = subject.mesh;
  const double density = subject.density;
  const auto point = [&](const std::string& name, auto&& method) {
    support::Series series{name, {}, {}};
    extend(series, all.measure(name, method));
    plot.series.push_back(series);
  };
  const auto integrals = [&](Accuracy accuracy) {
    return
        [&mesh, density, accuracy] { return unchecked_mass_properties(mesh, density, accuracy); };
  };
  point("Mirtich", integrals(Accuracy::textbook));
  point("tetrahedra", integrals(Accuracy::fast));
  point("tetrahedra, tight", integrals(Accuracy::tight));
  all.measure("tight, mesh diagnosed first", [&] { return mesh_mass_properties(mesh, density); });
}

}  // namespace

void show_mass(const Subject& subject, Output& output) {
  Measurements all(subject);
  support::Plot plot{"inertia of " + subject.name,
                     {"time [s]", support::Scale::log},
                     {"relative error of the inertia tensor", support::Scale::log},
                     {}};
  measure_boxes(subject, all, plot);
  measure_points(subject, all, plot);
  measure_integrals(subject, all, plot);
  output.show(
      "Mass properties three ways: boxes, points, integrals. We measure errors from the exact "
      "value",
      all.table(), "mass");
  output.write("mass.svg", support::to_svg(plot));
}

}  // namespace tumble::tour
