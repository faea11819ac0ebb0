#include "judge/spec/demand.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tumble::judge {

namespace {

constexpr double incomparable = std::numeric_limits<double>::quiet_NaN();

double difference(double a, double b) {
  const bool same_place = a == b || (std::isnan(a) && std::isnan(b));
  if (same_place) return 0;
  return std::isfinite(a) && std::isfinite(b) ? std::abs(a - b) : incomparable;
}

double difference(const List& a, const List& b, double sign) {
  if (a.size() != b.size()) return incomparable;
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double* x = a[i].as<double>();
    const double* y = b[i].as<double>();
    largest = worse(x && y ? difference(*x, sign * *y) : largest_difference(a[i], b[i]), largest);
  }
  return largest;
}

}  // namespace

double largest_difference(const Value& a, const Value& b) {
  if (const double* x = a.as<double>(), *y = b.as<double>(); x && y) return difference(*x, *y);
  if (const List* x = a.as<List>(), *y = b.as<List>(); x && y) return difference(*x, *y, 1);
  if (const auto* x = a.as<std::int64_t>(), *y = b.as<std::int64_t>(); x && y)
    return std::abs(static_cast<double>(*x) - static_cast<double>(*y));
  if (const auto* x = a.as<std::string>(), *y = b.as<std::string>(); x && y && *x == *y) return 0;
  return incomparable;
}

double largest_magnitude(const Value& value) {
  if (const double* x = value.as<double>()) return std::isfinite(*x) ? std::abs(*x) : 0;
  double largest = 0;
  if (const List* list = value.as<List>())
    for (const Value& element : *list) largest = std::fmax(largest, largest_magnitude(element));
  return largest;
}

double difference_up_to_sign(const Value& a, const Value& b) {
  const List *x = a.as<List>(), *y = b.as<List>();
  if (!x || !y) return incomparable;
  return std::fmin(difference(*x, *y, 1), difference(*x, *y, -1));
}

Value with_sign_of(const Value& q, const Value& answer) {
  const List *x = q.as<List>(), *y = answer.as<List>();
  if (!x || !y || !(difference(*x, *y, -1) < difference(*x, *y, 1))) return q;
  List other = *x;
  for (Value& each : other)
    if (const double* number = each.as<double>()) each = Value(-*number);
  return {std::move(other)};
}

}  // namespace tumble::judge
