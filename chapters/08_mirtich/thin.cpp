/// @file
/// Needles and plates that lie askew, and the bounds that say what is left of their digits.

#include "common.hpp"
#include "lattice_tetrahedron.hpp"
#include "parts.hpp"
#include "support/plot.hpp"

namespace mirtich_chapter {

namespace {

double mass_error(const BoundedMassProperties& found, const LatticeTetrahedron& body) {
  return std::abs(double((simd::DoubleDouble(found.mass) - body.volume) / body.volume));
}

/// The worst of several bodies that lie differently.
struct ThinErrors {
  double fast = 0, fast_bound = 0, textbook = 0, textbook_bound = 0, tight = 0, tight_bound = 0;
};

ThinErrors thin_errors(const Vec3& sizes) {
  Random random(8);
  ThinErrors worst;
  for (int i = 0; i < 12; ++i) {
    const LatticeTetrahedron body = lattice_tetrahedron(exp_rotation(random.vector(3)), sizes);
    const auto note = [&](Accuracy accuracy, double& error, double& bound) {
      const BoundedMassProperties found = computed(body.mesh, accuracy);
      require(mass_error(found, body) <= found.mass_error_bound, "a bound does not hold");
      error = std::max(error, mass_error(found, body));
      bound = std::max(bound, found.mass_error_bound);
    };
    note(Accuracy::fast, worst.fast, worst.fast_bound);
    note(Accuracy::textbook, worst.textbook, worst.textbook_bound);
    note(Accuracy::tight, worst.tight, worst.tight_bound);
  }
  return worst;
}

}  // namespace

Table thin_table() {
  Table table({"1 / t", "plate, fast", "bound", "needle, fast", "bound", "needle, tight", "bound"});
  for (const double t : {1., 1e-2, 1e-4, 1e-6, 1e-8}) {
    const ThinErrors plate = thin_errors({1, 1, t}), needle = thin_errors({1, t, t});
    table.add({number(1 / t), error_or_rounding(plate.fast), error_or_rounding(plate.fast_bound),
               error_or_rounding(needle.fast), error_or_rounding(needle.fast_bound),
               error_or_rounding(needle.tight), error_or_rounding(needle.tight_bound)});
  }
  return table;
}

std::string thin_figure() {
  support::Plot plot{"needles and plates that lie askew",
                     {"length divided by thickness", support::Scale::log},
                     {"relative error of the mass, worst of 12", support::Scale::log},
                     {}};
  const std::array<std::string, 7> names{
      "needle: fast's bound", "needle: fast",          "needle: textbook", "plate: fast's bound",
      "plate: fast",          "needle: tight's bound", "needle: tight"};
  for (const std::string& name : names) {
    const bool bound = name.ends_with("bound");
    plot.series.push_back({name, {}, {}, bound ? support::Look::dashed : support::Look::line});
  }
  for (int i = 0; i <= 16; ++i) {
    const double t = std::pow(10, -0.5 * i);
    const ThinErrors needle = thin_errors({1, t, t}), plate = thin_errors({1, 1, t});
    const std::array<double, 7> errors{needle.fast_bound, needle.fast, needle.textbook,
                                       plate.fast_bound,  plate.fast,  needle.tight_bound,
                                       needle.tight};
    for (std::size_t k = 0; k < names.size(); ++k) {
      plot.series[k].x.push_back(1 / t);
      plot.series[k].y.push_back(std::max(errors[k], 0x1p-55));
    }
  }
  return support::to_svg(plot);
}

}  // namespace mirtich_chapter
