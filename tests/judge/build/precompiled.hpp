// What every student's file includes anyway, compiled once; and what most of them make the compiler
// work out from that, worked out once. More of it makes the header larger and each file slower. A
// page downloads the header: there it has no more than what is included.

// In a product of two large matrices Eigen asks the processor for its caches and comments its own
// assembly. A student's file may have neither: it would look as if they had written assembler.
#define EIGEN_NO_CPUID
#define EIGEN_ASM_COMMENT(X)
#include <Eigen/Core>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#ifndef __wasm__
namespace tumble::judge::precompiled {

// Types only: a function that is called here would be compiled again with each file.
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector4d;
using Eigen::VectorXd;

/// An expression of this type.
template <class T>
const T& a();

template <class... Types>
inline constexpr bool known = ((sizeof(Types) > 0) && ...);

/// With what Eigen takes their coefficients from.
template <class... Expressions>
inline constexpr bool known_to_eigen =
    known<Expressions..., Eigen::internal::evaluator<Expressions>...>;

template <class V>
inline constexpr bool sums_and_multiples =
    known_to_eigen<V, decltype(a<V>() + a<V>()), decltype(a<V>() - a<V>()), decltype(2.0 * a<V>()),
                   decltype(a<V>() * 2.0), decltype(a<V>() / 2.0), decltype(-a<V>()),
                   decltype(a<V>() + 2.0 * a<V>()), decltype(a<V>().transpose())>;

template <class M, class V>
inline constexpr bool products =
    known_to_eigen<decltype(a<M>() * a<M>()), decltype(a<M>() * a<V>()),
                   decltype(a<M>().transpose() * a<V>()), decltype(a<M>() * a<M>().transpose()),
                   decltype(a<V>() * a<V>().transpose()), decltype(a<M>().col(0)),
                   decltype(a<M>().row(0)), decltype(a<M>().row(0).transpose())>;

/// What is filled with a number, and what is written out with commas.
template <class V>
inline constexpr bool filled = known_to_eigen<decltype(V::Zero()), decltype(V::Constant(1.0))>&&
    known<decltype(std::declval<V&>() << 1.0)>;

/// Entries by their index: of Eigen's operators with brackets many are templates.
template <class V, class... Indices>
inline constexpr bool entries =
    known<decltype(a<V>()(Indices()...)), decltype(std::declval<V&>()(Indices()...))>;

template <class V>
inline constexpr bool geometry =
    known<decltype(a<V>().dot(a<V>())), decltype(a<V>().cross(a<V>())), decltype(a<V>().norm()),
          decltype(a<V>().squaredNorm()), decltype(a<V>().normalized())>;

static_assert(sums_and_multiples<Vector3d> && sums_and_multiples<Vector4d>);
static_assert(sums_and_multiples<VectorXd> && sums_and_multiples<Matrix3d>);
static_assert(products<Matrix3d, Vector3d> && geometry<Vector3d>);
static_assert(filled<Vector3d> && filled<Vector4d> && filled<Matrix3d>);
static_assert(known_to_eigen<decltype(Matrix3d::Identity())>);
static_assert(entries<Vector3d, int> && entries<VectorXd, int> && entries<Matrix3d, int, int>);
static_assert(known<std::vector<double>, std::vector<Vector3d>, std::vector<std::array<int, 3>>,
                    std::function<VectorXd(double, const VectorXd&)>>);

// Inline functions of the standard library use strings of all kinds, whose members each file would
// compile. What GCC runs here, it compiles here, once. (Clang compiles all of it in the header,
// with -fpch-instantiate-templates.)
#if defined(__GNUC__) && !defined(__clang__) && __cpp_lib_constexpr_string >= 201907L
template <class Character>
constexpr bool strings_work() {
  const Character letters[] = {'a', 'b', 0};
  std::basic_string<Character> text(letters, 2), other(2, letters[0]);
  text += other;
  text.append(letters).insert(0, letters).replace(0, 1, 2, letters[1]).resize(3);
  other = letters + text + other + std::basic_string<Character>(text);
  return !text.empty() && std::basic_string_view<Character>(other).size() == other.length();
}
static_assert(strings_work<char>() && strings_work<wchar_t>());
static_assert(strings_work<char8_t>() && strings_work<char16_t>() && strings_work<char32_t>());
#endif

}  // namespace tumble::judge::precompiled
#endif
