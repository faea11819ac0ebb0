#pragma once
/// @file
/// Solids made of solids: union, intersection and difference, nested as deep as one likes.
///
///     difference(Ball{1}, placed(Cylinder{0.3, 2}, Vec3(0.2, 0, 0)))  // a drilled ball
///
/// They are values, and hold the solids they are made of. Their mass properties have no closed form
/// in general: sampling::sample_mass_properties() counts points. Points on a surface that two
/// solids share may go either way: they have no volume. Source: Requicha, "Representations for
/// rigid solids: theory, methods, and systems", ACM Computing Surveys 12 (1980), §3.5.

#include <utility>

#include "tumble/core/solid.hpp"

namespace tumble::detail {

/// What is in a, in b or in both; counted once.
template <solids::Solid A, solids::Solid B>
struct Union {
  A a;
  B b;

  bool contains(const Vec3& point) const { return a.contains(point) || b.contains(point); }
  Eigen::AlignedBox3d bounds() const {
    return Eigen::AlignedBox3d(a.bounds()).merged(Eigen::AlignedBox3d(b.bounds()));
  }
};

/// What is both in a and in b.
template <solids::Solid A, solids::Solid B>
struct Intersection {
  A a;
  B b;

  bool contains(const Vec3& point) const { return a.contains(point) && b.contains(point); }
  /// Where both bounds are; empty when they do not meet.
  Eigen::AlignedBox3d bounds() const {
    const Eigen::AlignedBox3d both =
        Eigen::AlignedBox3d(a.bounds()).intersection(Eigen::AlignedBox3d(b.bounds()));
    return both.isEmpty() ? Eigen::AlignedBox3d() : both;
  }
};

/// What is in a but not in b.
template <solids::Solid A, solids::Solid B>
struct Difference {
  A a;
  B b;

  bool contains(const Vec3& point) const { return a.contains(point) && !b.contains(point); }
  /// Those of a: what b takes away is not known without looking.
  Eigen::AlignedBox3d bounds() const { return a.bounds(); }
};

}  // namespace tumble::detail

namespace tumble::solids {

/// @addtogroup mass
/// @{

/// a ∪ b. (`union` is a word of the language.)
template <Solid A, Solid B>
detail::Union<A, B> union_of(A a, B b) {
  return {std::move(a), std::move(b)};
}

/// a ∩ b.
template <Solid A, Solid B>
detail::Intersection<A, B> intersection(A a, B b) {
  return {std::move(a), std::move(b)};
}

/// a without b.
template <Solid A, Solid B>
detail::Difference<A, B> difference(A a, B b) {
  return {std::move(a), std::move(b)};
}

/// @}

}  // namespace tumble::solids
