#pragma once
/// @file
/// Results as JSON: every number with as many digits as tell it from its neighbours, NaN as null.

#include <nlohmann/json.hpp>
#include <string>

#include "tumble/core/types.hpp"

namespace tumble::scenes {

using Json = nlohmann::ordered_json;

inline Json as_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// (w, x, y, z)
inline Json as_json(const Quat& q) { return {q.w(), q.x(), q.y(), q.z()}; }

/// xx, yy, zz, xy, yz, zx; products with the minus sign.
inline Json as_json(const Mat3& I) {
  return {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(1, 2), I(2, 0)};
}

/// As a text. A name that is not UTF-8, as a file's may be, loses the bytes that are not, and
/// nothing else is lost.
inline std::string json_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

/// The members of an object that has some, without the lines of its braces.
inline std::string members_text(const Json& object) {
  const std::string text = json_text(object), opens = "{\n", closes = "\n}";
  return text.substr(opens.size(), text.size() - opens.size() - closes.size());
}

/// A text as a part of another one, its lines so many columns to the right.
inline std::string deeper(const std::string& text, std::size_t columns) {
  const std::string margin(columns, ' ');
  std::string moved = margin;
  for (const char c : text) {
    moved += c;
    if (c == '\n') moved += margin;
  }
  return moved;
}

}  // namespace tumble::scenes
