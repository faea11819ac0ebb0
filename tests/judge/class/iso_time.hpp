#pragma once
/// @file
/// Moments as files and platforms write them.

#include <cstdint>
#include <optional>
#include <string>

namespace tumble::judge {

/// Seconds since 1970 began in Greenwich, of "2026-12-01T23:59:00+01:00"; seconds, and their
/// fraction, may be left out. Nothing for a text that is no moment: without a time zone, or on 30
/// February.
/// Source: ISO 8601, RFC 3339.
std::optional<std::int64_t> moment_of(const std::string& text);

}  // namespace tumble::judge
