#pragma once
/// @file
/// Points in time, as people, course.json and platforms write them.

#include <cstdint>
#include <optional>
#include <string>

namespace tumble::judge {

/// Seconds since 1970 in UTC.
using Moment = std::int64_t;

/// Whether a time says in which zone it is: "…+01:00", "…Z", "… UTC".
bool names_zone(const std::string& text);

/// How far the time zone of an ISO time is ahead of UTC [s]: "…+01:00", "…Z"; 0 if it has none.
std::int64_t zone_of(const std::string& text);

/// The moment that one of these means; nothing if it is none of them:
/// "2026-12-01T23:59:00+01:00", "2026-12-01 23:59:59.25 Z", "2026-12-01 23:59 -0800",
/// "Tuesday, 1 December 2026, 11:59 PM", "1 December 2026, 23:59".
/// @param zone ahead of UTC [s], for a time that does not name its own
std::optional<Moment> moment_of(const std::string& text, std::int64_t zone = 0);

/// The same for what has to be exact, as in course.json: ISO 8601 with a time zone,
/// "2026-12-01T23:59:00+01:00" or "2026-12-01T22:59Z".
std::optional<Moment> exact_moment_of(const std::string& text);

}  // namespace tumble::judge
