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

Table frames_table() {
  Table table({"ω =", "turned by 0°", "1°", "10°", "90°"});
  const Mat3 I_inv = Vec3(1, 1 / 2., 1 / 3.).asDiagonal();
  const Vec3 L(1, 2, 3), axis = Vec3(1, -1, 0.5).normalized();
  for (const FromL& way : ways_from_L) {
    std::vector<std::string> row{way.name};
    for (const double angle : {0., 1., 10., 90.}) {
      const Mat3 R = exp_rotation(Vec3(angle * degree * axis));
      const Vec3 right = ways_from_L[0].omega(R, I_inv, L), found = way.omega(R, I_inv, L);
      const double off = (found - right).norm() / right.norm();
      row.push_back(off < 1e-14 ? "right"
                                : support::svg_number(100 * off, off < 0.1 ? 1 : 0) + " %");
    }
    table.add(row);
  }
  return table;
}

}  // namespace rigid_body_chapter
