#pragma once
/// @file
/// What a closed surface encloses, in doubles, and how far rounding may have moved it.
///
/// 6 V = Σ (a − o) · ((b − a) × (c − a)) over the triangles, o one of the surface's own vertices:
/// nothing is lost when it is small or far away. Source: the divergence theorem; the bound after
/// Higham, "Accuracy and Stability of Numerical Algorithms" (2nd ed. 2002), §3.1.

#include "tumble/core/inline.hpp"
#include "tumble/core/rounding.hpp"
#include "tumble/mesh/polygon_mesh.hpp"
#include "tumble/mesh/triangle_blocks.hpp"
#include "tumble/simd/corners.hpp"
#include "tumble/simd/double_double.hpp"
#include "tumble/simd/loop_options.hpp"

namespace tumble::detail {

/// Sums over triangles.
struct EnclosedVolume {
  double six_volume = 0;  ///< [m³], negative when the faces look inwards
  double magnitude = 0;  ///< Σ |a − o|₁ |b − a|₁ |c − a|₁: the rounding is some eps of it [m³]
  double twice_area = 0;  ///< of the surface, or up to √3 times as much [m²]
  double doubtful = 0;    ///< how many triangles may have no area

  EnclosedVolume& operator+=(const EnclosedVolume& other) {
    six_volume += other.six_volume;
    magnitude += other.magnitude;
    twice_area += other.twice_area;
    doubtful += other.doubtful;
    return *this;
  }
};

/// One triangle, or a pack of them. (The area is that of the shadows along the axes. n is 0 or NaN,
/// or so short that rounding may have made it.)
template <class P>
struct VolumeTerms {
  P six_volume, magnitude, twice_area, doubtful;

  TUMBLE_INLINE VolumeTerms(const simd::Point<P>& a, const simd::Point<P>& b,
                            const simd::Point<P>& c, const simd::Point<P>& o) {
    const simd::Point<P> r = a - o, u = b - a, v = c - a, n = cross(u, v);
    const P size = norm1(u) * norm1(v);
    six_volume = dot(r, n);
    magnitude = norm1(r) * size;
    twice_area = norm1(n);
    doubtful = simd::one_unless_greater(twice_area, size * (8 * unit_roundoff));
  }
};

/// Adds up what the triangles of a block enclose with the point `origin`.
struct BlockVolume {
  const TriangleBlock& block;
  const Vec3& origin;
  EnclosedVolume& sum;

  template <class P, simd::Fma>
  TUMBLE_INLINE void run() const {
    const simd::Point<P> o{P{} + origin.x(), P{} + origin.y(), P{} + origin.z()};  // in all lanes
    P six_volume{}, magnitude{}, twice_area{}, doubtful{};
    for (int i = 0; i < block.size; i += simd::lanes<P>) {
      const int* corners = block.corners + 3 * i;
      const VolumeTerms<P> terms(simd::load_corners<P>(block.coordinates, corners, 0),
                                 simd::load_corners<P>(block.coordinates, corners, 1),
                                 simd::load_corners<P>(block.coordinates, corners, 2), o);
      six_volume += terms.six_volume;
      magnitude += terms.magnitude;
      twice_area += terms.twice_area;
      doubtful += terms.doubtful;
    }
    sum += {simd::sum_of_lanes(six_volume), simd::sum_of_lanes(magnitude),
            simd::sum_of_lanes(twice_area), simd::sum_of_lanes(doubtful) - block.padding};
  }
};

/// What a surface encloses.
/// @param mesh closed, indices in range, positions finite, at least one face
EnclosedVolume enclosed_by(const PolygonMesh& mesh, const simd::LoopOptions& options = {});

/// The volume that a surface encloses, negative when its faces look inwards [m³].
/// @param mesh closed, indices in range, positions finite, at least one face
inline double enclosed_volume(const PolygonMesh& mesh, const simd::LoopOptions& options = {}) {
  return enclosed_by(mesh, options).six_volume / 6;
}

/// 6V of the tetrahedron on the triangle a, b, c with apex o, to about 2⁻¹⁰⁴ |b − a|₁ |c − a|₁
/// |a − o|₁ [m³]: so thin a one that doubles cancel has a volume too.
simd::DoubleDouble precise_six_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& o);

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/enclosed_volume.inl"
#endif
