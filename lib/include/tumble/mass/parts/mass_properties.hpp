#pragma once
/// @file
/// Mass properties of a body made of several materials: of each part, and of the whole.

#include <span>
#include <string>
#include <vector>

#include "tumble/mass/mesh_mass_properties.hpp"
#include "tumble/mass/parts/split.hpp"
#include "tumble/mesh/labelled_mesh.hpp"

namespace tumble::parts {

/// @addtogroup mass
/// @{

/// A part, and what it adds to the whole.
struct PartMass : BoundedMassProperties {
  std::string name;
  double density = 1;  ///< [kg/m³]
  int faces = 0;       ///< how many
};

/// The whole body, its parts, and everything that was found about them.
struct Assembly : BoundedMassProperties {
  std::vector<PartMass> parts;
  std::vector<MeshDefect> findings;  ///< of diagnose(); with Policy::refuse nothing that spoils
};

/// @}

}  // namespace tumble::parts

namespace tumble::detail {

/// Σ ρ ∫ over the parts, about one point.
///
/// With d from that point to the one that a part's integrals are about, r = s + d: ∫ r = ∫ s + d V,
/// ∫ r rᵀ = ∫ s sᵀ + ∫ s dᵀ + d ∫ sᵀ + d dᵀ V. What rounding did to the three is moved alike. What
/// it does here is at most 64 u² of each term, and 4 u² for each part that is added: a 32nd, and a
/// 512th, of the errors that the integrals bring with them, which are 2048 u² of the same terms or
/// more (rounding_sums.hpp).
class WeightedIntegrals {
 public:
  WeightedIntegrals(const Vec3& about, std::size_t parts)
      : about_(about), rounding_(1 + (64 + 4 * static_cast<double>(parts)) / 2048) {}

  void add(const MeshIntegrals& part, double density) {
    using T = simd::DoubleDouble;
    const auto offset = [&](int k) { return T(two_diff(part.reference[k], about_[k])); };
    const T dx = offset(0), dy = offset(1), dz = offset(2);
    Moments<T> m = part.moments;
    m.xx += dx * (m.x + m.x + dx * m.one);
    m.yy += dy * (m.y + m.y + dy * m.one);
    m.zz += dz * (m.z + m.z + dz * m.one);
    m.xy += dx * m.y + dy * m.x + dx * dy * m.one;
    m.yz += dy * m.z + dz * m.y + dy * dz * m.one;
    m.zx += dz * m.x + dx * m.z + dz * dx * m.one;
    m.x += dx * m.one;
    m.y += dy * m.one;
    m.z += dz * m.one;
    for (T* sum : {&m.one, &m.x, &m.y, &m.z, &m.xx, &m.yy, &m.zz, &m.xy, &m.yz, &m.zx})
      *sum *= density;
    moments_ += m;
    add_errors(part.errors, (part.reference - about_).norm(), density);
  }

  /// The body that they all make.
  BoundedMassProperties body() const { return bounded(moments_, about_, 1, errors_); }

 private:
  void add_errors(const IntegralErrors& of, double d, double density) {
    const double weight = rounding_ * density;
    errors_.volume += weight * of.volume;
    errors_.first += weight * (of.first + d * of.volume);
    errors_.second += weight * (of.second + 2 * d * of.first + d * d * of.volume);
  }

  Vec3 about_;
  double rounding_;
  Moments<simd::DoubleDouble> moments_;
  IntegralErrors errors_{};
};

}  // namespace tumble::detail

namespace tumble::parts {

/// @addtogroup mass
/// @{

/// Mass properties of parts that are known to be closed, and not to overlap; nothing is checked.
Assembly unchecked_mass_properties(std::span<const Part> parts, Accuracy accuracy = Accuracy::tight,
                                   const simd::LoopOptions& loop = {});

/// Refuses parts of which no digit is certain, and says which.
/// @throws std::invalid_argument as require_volume() does
void require_volumes(const Assembly& body);

/// Mass, centre of mass and inertia of a body whose parts have densities of their own, with bounds
/// of their rounding errors: of each part and of the whole. Holes in a part are surfaces of this
/// part that look inwards; another part may fill them.
/// @param mesh      of an OBJ file, see read_mesh(); each part is closed, faces counter-clockwise
///                  seen from outside [m]
/// @param densities of all faces, by the names of materials, groups or objects [kg/m³]
/// @throws std::invalid_argument as split() does; and as tumble::mesh_mass_properties() does, of
///         each part and also if parts overlap
Assembly mass_properties(const LabelledMesh& mesh, const Densities& densities,
                         const MassOptions& options = {});

/// @}

}  // namespace tumble::parts

#ifndef TUMBLE_COMPILED
#include "tumble/mass/parts/mass_properties.inl"
#endif
