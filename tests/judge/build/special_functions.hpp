#pragma once
/// @file
/// The special functions of <cmath>: Bessel's, Legendre's, the elliptic integrals. libstdc++ has
/// each for float and long double as an inline function around a template, and GCC instantiates
/// those forty templates with every file, used or not. So they are instantiated once, in the
/// worker's library. What they are called inside libstdc++ is known up to this release of it.

#include <cmath>

#if defined(__GLIBCXX__) && _GLIBCXX_RELEASE <= 15 && _GLIBCXX_USE_STD_SPEC_FUNCS
#define TUMBLE_SPECIAL_FUNCTIONS(instantiation, T)                                \
  instantiation T std::__detail::__assoc_laguerre<T>(unsigned, unsigned, T);      \
  instantiation T std::__detail::__assoc_legendre_p<T>(unsigned, unsigned, T, T); \
  instantiation T std::__detail::__beta<T>(T, T);                                 \
  instantiation T std::__detail::__comp_ellint_1<T>(T);                           \
  instantiation T std::__detail::__comp_ellint_2<T>(T);                           \
  instantiation T std::__detail::__comp_ellint_3<T>(T, T);                        \
  instantiation T std::__detail::__cyl_bessel_i<T>(T, T);                         \
  instantiation T std::__detail::__cyl_bessel_j<T>(T, T);                         \
  instantiation T std::__detail::__cyl_bessel_k<T>(T, T);                         \
  instantiation T std::__detail::__cyl_neumann_n<T>(T, T);                        \
  instantiation T std::__detail::__ellint_1<T>(T, T);                             \
  instantiation T std::__detail::__ellint_2<T>(T, T);                             \
  instantiation T std::__detail::__ellint_3<T>(T, T, T);                          \
  instantiation T std::__detail::__expint<T>(T);                                  \
  instantiation T std::__detail::__poly_hermite<T>(unsigned, T);                  \
  instantiation T std::__detail::__laguerre<T>(unsigned, T);                      \
  instantiation T std::__detail::__poly_legendre_p<T>(unsigned, T);               \
  instantiation T std::__detail::__riemann_zeta<T>(T);                            \
  instantiation T std::__detail::__sph_bessel<T>(unsigned, T);                    \
  instantiation T std::__detail::__sph_legendre<T>(unsigned, unsigned, T);        \
  instantiation T std::__detail::__sph_neumann<T>(unsigned, T);
#else
#define TUMBLE_SPECIAL_FUNCTIONS(instantiation, T)
#endif
