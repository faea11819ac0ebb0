#pragma once
/// @file
/// Whether AddressSanitizer watches: then a test takes ten to twenty times as long.

namespace tumble::test {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif

/// How often something is tried: with sanitizers a part is enough, for they look at memory, not at
/// numbers.
constexpr int tries(int count, int part = 10) {
  return sanitized ? (count + part - 1) / part : count;
}

}  // namespace tumble::test
