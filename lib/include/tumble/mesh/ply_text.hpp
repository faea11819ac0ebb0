#pragma once
/// @file
/// The values of an ASCII PLY file: each element is a line.

#include <cmath>

#include "tumble/mesh/parse_number.hpp"
#include "tumble/mesh/ply_header.hpp"
#include "tumble/mesh/text_scanner.hpp"

namespace tumble::detail {

/// Gives the values one after the other; PlyBytes does the same for binary files.
class PlyText {
 public:
  /// @param text after the header
  explicit PlyText(const TextScanner& text) : text_(text) {}

  /// Refuses an element that cannot be there as often as the header says: a value takes two bytes,
  /// the last one perhaps one.
  void require_room(const PlyElement& element) const {
    const std::int64_t size = 2 * static_cast<std::int64_t>(element.properties.size());
    if (element.count > (static_cast<std::int64_t>(text_.bytes_left()) + 1) / size)
      text_.refuse("the header announces ", element.count, " elements '", shown(element.name),
                   "', but only ", text_.bytes_left(), " bytes follow");
  }

  void begin(const PlyElement& element, std::int64_t index) {
    element_ = &element;
    number_ = index + 1;
    text_.skip_to_word();
  }

  void end() {
    const std::string_view word = text_.next_word();
    if (!word.empty()) refuse("has '", shown(word), "' after its last value");
  }

  /// @return a number that the type holds
  double next(const PlyProperty& property, PlyType type) {
    const std::string_view word = next_word(property);
    const Parsed<double> value = parse_double(word.data(), word.data() + word.size());
    if (value.end != word.data() + word.size() || !std::isfinite(value.value))
      refuse("has '", shown(word), "' for '", shown(property.name),
             "', which is not a finite number");
    const PlyTypeName& limits = about(type);
    if (is_integer(type) && !(value.value >= limits.min && value.value <= limits.max &&
                              value.value == std::floor(value.value)))
      refuse("has '", shown(word), "' for '", shown(property.name), "', which is not of the type ",
             limits.name);
    return value.value;
  }

  /// Passes over some values, whatever they are.
  void skip(const PlyProperty& property, PlyType, std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) next_word(property);
  }

  void require_end() {
    text_.skip_to_word();
    if (!without_padding({text_.at(), text_.bytes_left()}).empty())
      text_.refuse("'", shown(text_.peek_word()), "' after the last element");
  }

  template <class... Parts>
  [[noreturn]] void refuse(const Parts&... message) const {
    text_.refuse(shown(element_->name), " #", number_, ' ', message...);
  }

 private:
  std::string_view next_word(const PlyProperty& property) {
    const std::string_view word = text_.next_word();
    if (word.empty()) refuse("has no value for '", shown(property.name), "'");
    return word;
  }

  TextScanner text_;
  const PlyElement* element_ = nullptr;
  std::int64_t number_ = 0;
};

}  // namespace tumble::detail
