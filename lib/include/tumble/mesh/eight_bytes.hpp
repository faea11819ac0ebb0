#pragma once
/// @file
/// Eight bytes of a text at a time: long runs that nobody needs are passed over at that pace.
///
/// Source: H. S. Warren, Hacker's Delight, 2nd edition, section 6-1 (find first 0-byte).

#include <bit>
#include <cstdint>
#include <cstring>

namespace tumble::detail {

/// Whether the first of eight bytes is the lowest of their number, as the search needs it.
constexpr bool first_is_lowest = std::endian::native == std::endian::little;

/// The same byte eight times.
constexpr std::uint64_t eight(unsigned char byte) { return 0x0101010101010101u * byte; }

inline std::uint64_t load_eight(const char* at) {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, at, 8);
  return bytes;
}

/// The high bit of each byte that is less than `limit` (at most 128); above the first such byte,
/// bits may be wrong.
constexpr std::uint64_t bytes_below(std::uint64_t bytes, unsigned char limit) {
  return (bytes - eight(limit)) & ~bytes & eight(0x80);
}

/// The first byte from `at` on that is less than `limit` (at most 128), or the end.
inline const char* find_below(const char* at, const char* end, unsigned char limit) {
  if constexpr (first_is_lowest)
    for (; end - at >= 8; at += 8) {
      const std::uint64_t found = bytes_below(load_eight(at), limit);
      if (found != 0) return at + std::countr_zero(found) / 8;
    }
  while (at != end && static_cast<unsigned char>(*at) >= limit) ++at;
  return at;
}

}  // namespace tumble::detail
