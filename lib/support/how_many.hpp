#pragma once
/// @file
/// "1 exercise", "2 exercises".

#include <string>

namespace tumble::support {

/// @param thing in the singular, of those that only take an s
template <class Count>
std::string how_many(Count count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

}  // namespace tumble::support
