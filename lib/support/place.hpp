#pragma once
/// @file
/// A place in a JSON file: its value, and its name for messages, such as `bodies[0].omega`.

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "support/nearest.hpp"
#include "support/printable.hpp"
#include "tumble/core/require.hpp"
#include "tumble/core/types.hpp"

namespace tumble::support {

/// A value of a JSON document that knows where it is.
class Place {
 public:
  using Json = nlohmann::json;

  Place(const Json& value, std::string name) : value_(value), name_(std::move(name)) {}

  const std::string& name() const { return name_; }
  bool has(const char* key) const { return value_.is_object() && value_.contains(key); }
  bool is_object() const { return value_.is_object(); }

  /// @throws std::invalid_argument if there is no such key
  Place operator[](const char* key) const {
    require(has(key), name_, " has no \"", key, "\"");
    return {value_.at(key), name_ + "." + key};
  }

  /// The elements of a list.
  std::vector<Place> elements() const {
    require(value_.is_array(), name_, " is not a list, but ", value_.dump());
    std::vector<Place> places;
    for (std::size_t i = 0; i < value_.size(); ++i)
      places.emplace_back(value_[i], name_ + "[" + std::to_string(i) + "]");
    return places;
  }

  /// The names and values of { … }.
  std::vector<std::pair<std::string, Place>> members() const {
    require(value_.is_object(), name_, " is not { … }, but ", value_.dump());
    std::vector<std::pair<std::string, Place>> places;
    for (const auto& [key, value] : value_.items())
      places.emplace_back(key, Place(value, name_ + "." + escaped(key)));
    return places;
  }

  double number() const {
    require(value_.is_number(), name_, " is not a number, but ", value_.dump());
    return value_.get<double>();
  }
  double positive_number() const {
    const double x = number();
    require(x > 0, name_, " is ", x, "; it must be positive");
    return x;
  }
  double number_or(const char* key, double otherwise) const {
    return has(key) ? (*this)[key].number() : otherwise;
  }

  bool yes() const {
    require(value_.is_boolean(), name_, " is not true or false, but ", value_.dump());
    return value_.get<bool>();
  }

  std::string text() const {
    require(value_.is_string(), name_, " is not a text, but ", value_.dump());
    return value_.get<std::string>();
  }

  /// A list of n numbers.
  template <int n>
  Eigen::Matrix<double, n, 1> numbers() const {
    const std::vector<Place> list = elements();
    require(list.size() == n, name_, " has ", list.size(), " numbers, not ", n);
    Eigen::Matrix<double, n, 1> v;
    for (int i = 0; i < n; ++i) v[i] = list[static_cast<std::size_t>(i)].number();
    return v;
  }
  Vec3 vector() const { return numbers<3>(); }
  Vec3 vector_or(const char* key, const Vec3& otherwise) const {
    return has(key) ? (*this)[key].vector() : otherwise;
  }

  /// Refuses keys that mean nothing here: they may be misspelt.
  void require_only(std::initializer_list<const char*> known) const {
    require(value_.is_object(), name_, " is not { … }, but ", value_.dump());
    for (const auto& [key, value] : value_.items()) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      const std::string meant = did_you_mean(key, {known.begin(), known.end()});
      require(false, name_, " has \"", escaped(key), "\", which means nothing here",
              meant.empty() ? "; there are: " + listed(known) : meant);
    }
  }

  /// The same where { } means nothing: then we say what there is.
  void require_some(std::initializer_list<const char*> known) const {
    require_only(known);
    require(!value_.empty(), name_, " is empty; there are: ", listed(known));
  }

  /// The one key of { … } that says which kind of thing this is.
  /// @param advice where there are two
  /// @throws std::invalid_argument unless there is exactly one, and it is known
  std::string only_key(std::initializer_list<const char*> known, const std::string& advice) const {
    require_only(known);
    require(!value_.empty(), name_, " is empty: give one of ", listed(known));
    const std::string first = value_.begin().key(), last = std::prev(value_.end()).key();
    require(value_.size() == 1, name_, " has \"", first, "\" and \"", last, "\": ", advice);
    return first;
  }

  /// What `f()` gives; its refusals, and those of files that it reads, say where, once.
  template <class F>
  auto refused_here(F&& f) const -> decltype(f()) {
    try {
      return f();
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(with_name(error.what()));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(with_name(error.what()));
    }
  }

 private:
  std::string with_name(const std::string& what) const {
    return what.starts_with(name_) ? what : name_ + ": " + what;
  }
  static std::string listed(std::initializer_list<const char*> names) {
    std::string list;
    for (const char* name : names) list += (list.empty() ? "" : ", ") + std::string(name);
    return list;
  }

  const Json& value_;
  std::string name_;
};

}  // namespace tumble::support
