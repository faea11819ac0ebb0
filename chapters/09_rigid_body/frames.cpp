/// @file
/// ω from L with the right axes, and with wrong ones.

#include "common.hpp"
#include "parts.hpp"

namespace rigid_body_chapter {

namespace {

/// A way from L to ω.
struct FromL {
  std::string name;
  Vec3 (*omega)(const Mat3& R, const Mat3& I_inv, const Vec3& L);
};

const std::array<FromL, 5> ways_from_L{
    FromL{"R I⁻¹ Rᵀ L",
          [](const Mat3& R, const Mat3& I_inv, const Vec3& L) -> Vec3 {
            return R * (I_inv * (R.transpose() * L));
          }},
    {"I⁻¹ L", [](const Mat3&, const Mat3& I_inv, const Vec3& L) -> Vec3 { return I_inv * L; }},
    {"I⁻¹ Rᵀ L",
     [](const Mat3& R, const Mat3& I_inv, const Vec3& L) -> Vec3 {
       return I_inv * (R.transpose() * L);
     }},
    {"R I⁻¹ L",
     [](const Mat3& R, const Mat3& I_inv, const Vec3& L) -> Vec3 { return R * (I_inv * L); }},
    {"Rᵀ I⁻¹ R L", [](const Mat3& R, const Mat3& I_inv, const Vec3& L) -> Vec3 {
       return R.transpose() * (I_inv * (R * L));
     }}};

}  // namespace

namespace {

const Vec3 some_L(1, 2, 3);
const Mat3 I_inv_123 = Vec3(1, 1 / 2., 1 / 3.).asDiagonal();

/// How far ω is off, in percent of the right one.
std::string error_of(const FromL& way, const Mat3& R) {
  const Vec3 right = ways_from_L[0].omega(R, I_inv_123, some_L);
  const double off = (way.omega(R, I_inv_123, some_L) - right).norm() / right.norm();
  return off < 1e-14 ? "right" : support::svg_number(100 * off, off < 0.1 ? 1 : 0) + " %";
}

}  // namespace

Table frames_table() {
  Table table({"ω =", "turned by 0°", "1°", "10°", "90°"});
  const Vec3 axis = Vec3(1, -1, 0.5).normalized();
  for (const FromL& way : ways_from_L) {
    std::vector<std::string> row{way.name};
    for (const double angle : {0., 1., 10., 90.})
      row.push_back(error_of(way, exp_rotation(Vec3(angle * degree * axis))));
    table.add(row);
  }
  return table;
}

Table half_turn_table() {
  Table table({"ω =", "after a half turn about z"});
  const Mat3 half_turn = Vec3(-1, -1, 1).asDiagonal();
  for (const FromL& way : ways_from_L) table.add({way.name, error_of(way, half_turn)});
  return table;
}

}  // namespace rigid_body_chapter
