/// @file
/// Times as course.json and platforms write them.
#include "judge/class/moment.hpp"

#include <doctest/doctest.h>

using namespace tumble::judge;

TEST_CASE("moments: one time in all its spellings") {
  constexpr Moment expected = 1796165940;  // 2026-12-01T22:59:00Z
  for (const char* text :
       {"2026-12-01T23:59:00+01:00", "2026-12-01T22:59:00Z", "2026-12-01T22:59Z",
        "2026-12-01 22:59:00.184049000 Z", "2026-12-01 22:59:00 UTC", "2026-12-01 14:59:00 -0800"})
    CHECK_MESSAGE(moment_of(text) == expected, text);
  const std::int64_t zone = zone_of("2026-12-01T23:59:00+01:00");
  CHECK(zone == 3600);
  for (const char* text :
       {"Tuesday, 1 December 2026, 11:59 PM", "1 December 2026, 23:59", "2026-12-01 23:59:00"})
    CHECK_MESSAGE(moment_of(text, zone) == expected, text);
  CHECK(moment_of("1970-01-01T00:00Z") == 0);
}

TEST_CASE("moments: what is none") {
  for (const char* text : {"", "-", "tomorrow", "2026-13-45T99:99:00Z", "2026-02-30T10:00Z",
                           "1 Decembre 2026, 23:59", "32 May 2026, 10:00", "1 May 2026, 13:00 PM"})
    CHECK_MESSAGE(moment_of(text) == std::nullopt, text);
}
