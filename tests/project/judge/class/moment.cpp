/// @file
/// Times as course.json and platforms write them.
#include "judge/class/moment.hpp"

#include <doctest/doctest.h>

#include "judge/class/final_grade.hpp"
#include "judge/class/handed_in.hpp"

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

TEST_CASE("moments: a time that cannot be true is none") {
  const Moment now = *moment_of("2026-12-01T12:00:00Z");
  CHECK(handed_in("2026-12-01T12:00:00Z", 0, now).when == now);
  CHECK(handed_in("2026-12-02T11:59:59Z", 0, now).when.has_value());  // two clocks
  CHECK(handed_in("2026-12-02T12:00:01Z", 0, now).doubt == "is still to come");
  CHECK(handed_in("1 January 1970, 01:00", 3600, now).doubt == "is a clock that was never set");
  CHECK(handed_in("yesterday", 0, now).doubt == "cannot be read");
  CHECK(handed_in("", 0, now).doubt == "");
}

TEST_CASE("moments: which of them name a zone") {
  for (const char* text :
       {"2026-03-30T00:30:00Z", "2026-03-30 00:30 +0200", "2026-03-30 00:30 UTC"})
    CHECK_MESSAGE(names_zone(text), text);
  for (const char* text : {"2026-03-30 00:30", "30 March 2026, 00:30", "2026-03-30"})
    CHECK_FALSE_MESSAGE(names_zone(text), text);
}

TEST_CASE("late work: a clock without a zone may have been put forward, and that is said") {
  Course course;
  course.units = {{"4.1", "04_quaternions", "product", "", {}, {}}};
  CourseSettings settings = default_settings(course);
  settings.due = "2026-03-28T23:59:00+01:00";  // the night in which summer time begins
  settings.rules.late.emplace().per_day = 10;
  StudentRecord record{"ann", 1, 0, "", {}};
  const auto why = [&](const std::string& time) {
    record.handed_in = time;
    const FinalGrade grade = final_grade(settings, record);
    return grade.because.empty() ? "" : grade.because.front();
  };
  CHECK(why("30 March 2026, 00:30") ==
        "2 days late (1 if summer time began after the due date): −20 %");
  CHECK(why("2026-03-30T00:30:00+02:00") == "1 day late: −10 %");
  CHECK(why("29 March 2026, 12:30") == "1 day late: −10 %");
  CHECK(why("28 March 2026, 23:58") == "");
}
