#pragma once
/// @file
/// C++ types of a contract ↔ values. A vector is a list of numbers, a matrix a list of its rows, a
/// struct a list of its members. Reading checks every shape: the other side may be hostile.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "judge/protocol/aggregate.hpp"
#include "judge/protocol/value.hpp"

namespace tumble::judge {

/// A value that is not of the shape that was asked for.
struct Malformed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <class T>
concept EigenVector = std::is_base_of_v<Eigen::MatrixBase<T>, T> && bool(T::IsVectorAtCompileTime);
template <class T>
concept EigenMatrix = std::is_base_of_v<Eigen::MatrixBase<T>, T> && !bool(T::IsVectorAtCompileTime);
template <class T>
concept StandardList = requires(T list) {
  typename T::value_type;
  list.begin();
  list.size();
}
&&!std::is_same_v<T, std::string>;

// ── Writing ──

/// 0 or 1. A truth value that was never set is neither: then it is its byte, four times,
/// which is the mark of an int that was never set.
inline std::int64_t number_of_truth(const bool& x) {
  const unsigned byte = *reinterpret_cast<const volatile unsigned char*>(&x);
  if (byte <= 1) return byte;
  return static_cast<std::int32_t>(0x01010101u * byte);
}

template <class T>
Value to_value(const T& x) {
  if constexpr (std::is_same_v<T, bool>) {
    return number_of_truth(x);
  } else if constexpr (std::is_floating_point_v<T>) {
    return static_cast<double>(x);
  } else if constexpr (std::is_integral_v<T> || std::is_enum_v<T>) {
    return static_cast<std::int64_t>(x);
  } else if constexpr (std::is_same_v<T, std::string>) {
    return x;
  } else if constexpr (EigenVector<T>) {
    List list;
    for (Eigen::Index i = 0; i < x.size(); ++i) list.emplace_back(to_value(x[i]));
    return list;
  } else if constexpr (EigenMatrix<T>) {
    List rows;
    for (Eigen::Index i = 0; i < x.rows(); ++i) {
      List row;
      for (Eigen::Index j = 0; j < x.cols(); ++j) row.emplace_back(to_value(x(i, j)));
      rows.emplace_back(std::move(row));
    }
    return rows;
  } else if constexpr (StandardList<T>) {
    List list;
    for (const auto& element : x) list.emplace_back(to_value(element));
    return list;
  } else {
    List list;
    std::apply([&](const auto&... member) { (list.emplace_back(to_value(member)), ...); },
               members(x));
    return list;
  }
}

// ── Reading ──

inline const List& list_of(const Value& value) {
  const List* list = value.as<List>();
  if (!list) throw Malformed("a list of numbers was expected");
  return *list;
}

inline void require_size(std::size_t size, std::size_t expected) {
  if (size != expected)
    throw Malformed(std::to_string(expected) + " entries were expected, got " +
                    std::to_string(size));
}

/// A number; an integer is taken for a floating-point number, not the other way round.
template <class T>
T number_of(const Value& value) {
  if constexpr (std::is_floating_point_v<T>)
    if (const double* x = value.as<double>()) return static_cast<T>(*x);
  const std::int64_t* n = value.as<std::int64_t>();
  if (!n) throw Malformed("a number was expected");
  if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>)
    if (!std::in_range<T>(*n)) throw Malformed("an integer is out of range");
  return static_cast<T>(*n);
}

template <class T>
T from_value(const Value& value);

template <EigenVector T>
T vector_of(const Value& value) {
  const List& list = list_of(value);
  constexpr int fixed = T::SizeAtCompileTime;
  if constexpr (fixed != Eigen::Dynamic) require_size(list.size(), static_cast<std::size_t>(fixed));
  T x(static_cast<Eigen::Index>(list.size()));
  for (std::size_t i = 0; i < list.size(); ++i)
    x[static_cast<Eigen::Index>(i)] = from_value<typename T::Scalar>(list[i]);
  return x;
}

template <EigenMatrix T>
T matrix_of(const Value& value) {
  const List& rows = list_of(value);
  const std::size_t columns = rows.empty() ? 0 : list_of(rows[0]).size();
  if constexpr (T::RowsAtCompileTime != Eigen::Dynamic)
    require_size(rows.size(), static_cast<std::size_t>(T::RowsAtCompileTime));
  if constexpr (T::ColsAtCompileTime != Eigen::Dynamic)
    require_size(columns, static_cast<std::size_t>(T::ColsAtCompileTime));
  T x(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const List& row = list_of(rows[i]);
    require_size(row.size(), columns);
    for (std::size_t j = 0; j < columns; ++j)
      x(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          from_value<typename T::Scalar>(row[j]);
  }
  return x;
}

template <class T>
T standard_list_of(const Value& value) {
  const List& list = list_of(value);
  T x{};
  if constexpr (requires { x.resize(list.size()); })
    x.resize(list.size());
  else
    require_size(list.size(), x.size());
  for (std::size_t i = 0; i < list.size(); ++i) x[i] = from_value<typename T::value_type>(list[i]);
  return x;
}

template <class T>
T struct_of(const Value& value) {
  const List& list = list_of(value);
  T x{};
  require_size(list.size(), member_count<T>());
  std::size_t i = 0;
  std::apply(
      [&](auto&... member) {
        ((member = from_value<std::remove_cvref_t<decltype(member)>>(list[i++])), ...);
      },
      members(x));
  return x;
}

/// The value as a T.
/// @throws Malformed if it has another shape
template <class T>
T from_value(const Value& value) {
  if constexpr (std::is_arithmetic_v<T>) {
    return number_of<T>(value);
  } else if constexpr (std::is_enum_v<T>) {
    return static_cast<T>(number_of<std::underlying_type_t<T>>(value));
  } else if constexpr (std::is_same_v<T, std::string>) {
    const std::string* text = value.as<std::string>();
    if (!text) throw Malformed("a text was expected");
    return *text;
  } else if constexpr (EigenVector<T>) {
    return vector_of<T>(value);
  } else if constexpr (EigenMatrix<T>) {
    return matrix_of<T>(value);
  } else if constexpr (StandardList<T>) {
    return standard_list_of<T>(value);
  } else {
    return struct_of<T>(value);
  }
}

}  // namespace tumble::judge
