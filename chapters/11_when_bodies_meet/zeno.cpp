/// @file
/// Infinitely many bounces in a finite time.

#include "common.hpp"
#include "parts.hpp"

namespace contact_chapter {

namespace {

constexpr double zeno_height = 1;

double zeno_first() { return std::sqrt(2 * zeno_height / gravity); }

/// The time of the k-th contact: t₀ (1 + 2e + 2e² + … + 2eᵏ⁻¹).
double zeno_contact(double e, int k) {
  double t = zeno_first(), flight = 2 * t;
  for (int i = 1; i < k; ++i) t += flight *= e;
  return t;
}

double zeno_end(double e) { return zeno_first() * (1 + e) / (1 - e); }

/// How high it rises after the k-th contact.
double zeno_rise(double e, int k) { return zeno_height * std::pow(e, 2 * k); }

}  // namespace

Table zeno_table() {
  Table table(
      {"contact", "e = 0.5: time [s]", "then rises [m]", "e = 0.8: time [s]", "then rises [m]"});
  for (const int k : {1, 2, 3, 5, 10, 20, 50})
    table.add({std::to_string(k), rounded(zeno_contact(0.5, k), 4), number(zeno_rise(0.5, k), 2),
               rounded(zeno_contact(0.8, k), 4), number(zeno_rise(0.8, k), 2)});
  table.add({"t₀ (1 + e)/(1 − e)", rounded(zeno_end(0.5), 4), "0", rounded(zeno_end(0.8), 4), "0"});
  return table;
}

}  // namespace contact_chapter
