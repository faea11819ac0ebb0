#pragma once
/// @file
/// The Laws of all forces on a Pack, asked one after the other. They are known at compile time: a
/// force that is not there costs nothing.

#include <tuple>
#include <utility>

#include "tumble/ensemble/laws.hpp"

namespace tumble::ensemble {

/// One of several, some of which may be of the same type.
template <std::size_t i, class T>
struct Numbered : T {};

template <class Numbers, class... Laws>
struct LawList;

/// Each law with its number, so that two of a kind are two.
template <std::size_t... i, class... Laws>
struct LawList<std::index_sequence<i...>, Laws...> : Numbered<i, Laws>... {
  static constexpr bool drags = (Laws::drags || ...);
  static constexpr bool steady = (Laws::steady && ...);

  template <int N>
  struct Series : Numbered<i, typename Laws::template Series<N>>... {};

  template <class Forces, class P>
  TUMBLE_INLINE void prepare(const Forces& forces, const PackBody<P>& body,
                             [[maybe_unused]] double h) {
    (law<i>().prepare(std::get<i>(forces), body, h), ...);
  }
  template <class P>
  TUMBLE_INLINE void add_push(Push<P>& push) const {
    (law<i>().add_push(push), ...);
  }
  template <class P>
  TUMBLE_INLINE void add_spin(const Quaternion<P>& q, const Point<P>& b, Point<P>& sum) const {
    (law<i>().add_spin(q, b, sum), ...);
  }
  template <class P>
  TUMBLE_INLINE void add_wrench([[maybe_unused]] double t, const PackBody<P>& body,
                                const PackMotion<P>& now, PackWrench<P>& sum) const {
    (law<i>().add_wrench(t, body, now, sum), ...);
  }
  template <int N, class P>
  TUMBLE_INLINE void start(Series<N>& all, const Quaternion<P>& q) const {
    (series<i>(all).start(law<i>(), q), ...);
  }
  template <int N, class P>
  TUMBLE_INLINE void add(Series<N>& all, [[maybe_unused]] int k, [[maybe_unused]] const Point<P>* b,
                         Point<P>& sum) const {
    (series<i>(all).add(law<i>(), k, b, sum), ...);
  }

 private:
  template <std::size_t n>
  using LawType = std::tuple_element_t<n, std::tuple<Laws...>>;
  template <std::size_t n>
  TUMBLE_INLINE const LawType<n>& law() const {
    return static_cast<const Numbered<n, LawType<n>>&>(*this);
  }
  template <std::size_t n>
  TUMBLE_INLINE LawType<n>& law() {
    return static_cast<Numbered<n, LawType<n>>&>(*this);
  }
  template <std::size_t n, int N>
  TUMBLE_INLINE static auto& series(Series<N>& all) {
    return static_cast<Numbered<n, typename LawType<n>::template Series<N>>&>(all);
  }
};

/// What force a Law is for.
template <class Force>
struct ForceType {
  using type = Force;
};
/// Forces that differ from body to body.
template <class Force>
struct ForceType<PerBody<Force>> {
  using type = Force;
};

/// The Laws of Forces, each a force or a PerBody of forces.
template <class P, class... Forces>
using LawsOf =
    LawList<std::index_sequence_for<Forces...>, Law<typename ForceType<Forces>::type, P>...>;

}  // namespace tumble::ensemble
