/// @file
/// Examples that fit on paper.

#include "common.hpp"
#include "parts.hpp"

namespace scene_chapter {

namespace {

std::string on_paper(double x) {
  const double rounded = std::round(1000 * x) / 1000;
  return number(rounded == 0 ? 0 : rounded, 4);
}

std::string on_paper(const Quat& q) {
  return "(" + on_paper(q.w()) + ", " + on_paper(q.x()) + ", " + on_paper(q.y()) + ", " +
         on_paper(q.z()) + ")";
}

std::string on_paper(const Vec3& v) {
  return "(" + on_paper(v.x()) + ", " + on_paper(v.y()) + ", " + on_paper(v.z()) + ")";
}

}  // namespace

Table top_by_hand_table() {
  constexpr double A = 1, C = 0.5, t = 1;
  const Quat q0 = turn({60 * degree, 0, 0});
  const Vec3 L(0, 0, pi), z = Vec3::UnitZ();
  const double rate = (1 / C - 1 / A) * L.dot(q0 * z);
  const Quat about_L = turn(t / A * L), about_z = turn(t * rate * z);
  const Quat q = about_L * q0 * about_z;
  Table table({"what", "number"});
  table.add({"q₀", on_paper(q0)});
  table.add({"n at time 0", on_paper(q0 * z)});
  table.add({"L · n", on_paper(L.dot(q0 * z))});
  table.add({"ρ", on_paper(rate)});
  table.add({"the turn about L", on_paper(about_L)});
  table.add({"the turn about z", on_paper(about_z)});
  table.add({"q₀ (about z)", on_paper(q0 * about_z)});
  table.add({"q(1 s)", on_paper(q)});
  table.add({"n at time 1 s", on_paper(q * z)});
  return table;
}

Table energy_by_hand_table() {
  constexpr std::array<double, 5> energies{10, 13, 12, 13, 12};  // [J], one per second
  Table table({"i", "E", "e", "i − mean", "(i − mean) e"});
  double sum = 0;
  for (std::size_t i = 0; i < energies.size(); ++i) {
    const double e = (energies[i] - energies[0]) / energies[0], s = static_cast<double>(i) - 2;
    sum += s * e;
    table.add(
        {std::to_string(i), number(energies[i]) + " J", on_paper(e), on_paper(s), on_paper(s * e)});
  }
  table.add({"sum", "", "", "", on_paper(sum)});
  return table;
}

}  // namespace scene_chapter
