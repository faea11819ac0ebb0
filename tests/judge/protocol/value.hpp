#pragma once
/// @file
/// What crosses the pipe between judge and worker: numbers, texts, lists of values, and functions
/// by number. Everything after the typed call (printing, comparing, storing) works on this.

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tumble::judge {

struct Value;
using List = std::vector<Value>;

/// A function that stays with the one who asks; the other side calls it back by its number.
struct FunctionId {
  std::int64_t number = 0;
  bool operator==(const FunctionId&) const = default;
};

struct Value {
  std::variant<double, std::int64_t, std::string, List, FunctionId> data = 0.0;

  Value() = default;
  Value(double x) : data(x) {}
  Value(std::int64_t n) : data(n) {}
  Value(std::string text) : data(std::move(text)) {}
  Value(List list) : data(std::move(list)) {}
  Value(FunctionId id) : data(id) {}

  /// This value as an alternative of the variant, or null.
  template <class T>
  const T* as() const {
    return std::get_if<T>(&data);
  }
};

}  // namespace tumble::judge
