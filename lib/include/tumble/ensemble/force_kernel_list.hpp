#pragma once
/// @file
/// The kernels of all forces on a Pack, asked one after the other. They are known at compile time:
/// a force that is not there costs nothing.

#include <tuple>
#include <type_traits>
#include <utility>

#include "tumble/ensemble/force_kernels.hpp"

namespace tumble::detail::ensembles {

/// One of several, some of which may be of the same type.
template <std::size_t i, class T>
struct Numbered : T {};

template <class Numbers, class... Kernels>
struct ForceKernelList;

/// Each kernel with its number, so that two of a kind are two. A std::tuple would fill them with
/// zeros first, which single steps of many bodies notice: they took up to 1.6 times as long.
template <std::size_t... i, class... Kernels>
struct ForceKernelList<std::index_sequence<i...>, Kernels...> : Numbered<i, Kernels>... {
  static constexpr bool drags = (Kernels::drags || ...);
  static constexpr bool steady = (Kernels::steady && ...);

  template <int N>
  struct Series : Numbered<i, typename Kernels::template Series<N>>... {};

  template <class Forces, class P>
  TUMBLE_INLINE void prepare(const Forces& forces, const ensemble::PackBody<P>& body,
                             [[maybe_unused]] double h) {
    (kernel<i>().prepare(std::get<i>(forces), body, h), ...);
  }
  template <class P>
  TUMBLE_INLINE void add_push(Push<P>& push) const {
    (kernel<i>().add_push(push), ...);
  }
  template <class P>
  TUMBLE_INLINE void add_spin(const Quaternion<P>& q, const Point<P>& b, Point<P>& sum) const {
    (kernel<i>().add_spin(q, b, sum), ...);
  }
  template <class P>
  TUMBLE_INLINE void add_wrench([[maybe_unused]] double t, const ensemble::PackBody<P>& body,
                                const ensemble::PackKinematics<P>& now,
                                ensemble::PackWrench<P>& sum) const {
    (kernel<i>().add_wrench(t, body, now, sum), ...);
  }
  template <int N, class P>
  TUMBLE_INLINE void start(Series<N>& all, const Quaternion<P>& q) const {
    (series<i>(all).start(kernel<i>(), q), ...);
  }
  template <int N, class P>
  TUMBLE_INLINE void add(Series<N>& all, [[maybe_unused]] int k, [[maybe_unused]] const Point<P>* b,
                         Point<P>& sum) const {
    (series<i>(all).add(kernel<i>(), k, b, sum), ...);
  }

 private:
  template <std::size_t n>
  using KernelType = std::tuple_element_t<n, std::tuple<Kernels...>>;
  template <std::size_t n>
  TUMBLE_INLINE const KernelType<n>& kernel() const {
    return static_cast<const Numbered<n, KernelType<n>>&>(*this);
  }
  template <std::size_t n>
  TUMBLE_INLINE KernelType<n>& kernel() {
    return static_cast<Numbered<n, KernelType<n>>&>(*this);
  }
  template <std::size_t n, int N>
  TUMBLE_INLINE static auto& series(Series<N>& all) {
    return static_cast<Numbered<n, typename KernelType<n>::template Series<N>>&>(all);
  }
};

/// What force a kernel is for.
template <class Force>
struct ForceType {
  using type = Force;
};
/// Forces that differ from body to body.
template <class Force>
struct ForceType<ensemble::PerBody<Force>> {
  using type = Force;
};

/// The kernels of Forces, each a force or a PerBody of forces.
template <class P, class... Forces>
struct ForceKernelsOf : ForceKernelList<std::index_sequence_for<Forces...>,
                                        ForceKernel<typename ForceType<Forces>::type, P>...> {
  /// Whether nothing acts but one weight for all, or nothing at all.
  static constexpr bool fall_alike = (std::is_same_v<Forces, Weight> && ...);
};

}  // namespace tumble::detail::ensembles
