#pragma once
/// @file
/// A hash that is the same on every platform and in every run, unlike std::hash.

#include <cstdint>
#include <string>

namespace tumble::judge {

/// FNV-1a (Fowler, Noll & Vo), begun with `start`.
inline std::uint64_t stable_hash(const std::string& text,
                                 std::uint64_t start = 0xcbf29ce484222325) {
  for (const char c : text) start = (start ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return start;
}

}  // namespace tumble::judge
