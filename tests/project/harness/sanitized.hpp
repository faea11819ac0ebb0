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

}  // namespace tumble::test
