#include "judge/class/moment.hpp"

#include <array>
#include <chrono>
#include <cstdlib>
#include <regex>

#include "judge/class/file_kinds.hpp"

namespace tumble::judge {

namespace {

struct CivilTime {
  int year = 0;
  unsigned month = 0, day = 0;
  int hour = 0, minute = 0, second = 0;
};

std::optional<Moment> utc(const CivilTime& t) {
  using namespace std::chrono;
  const year_month_day date{year{t.year}, month{t.month}, day{t.day}};
  if (!date.ok() || t.hour > 23 || t.minute > 59 || t.second > 59) return std::nullopt;
  const Moment days = sys_days{date}.time_since_epoch().count();
  return days * 86400 + t.hour * 3600 + t.minute * 60 + t.second;
}

int number_in(const std::ssub_match& match) { return match.matched ? std::stoi(match) : 0; }

/// 1 to 12 for an English name, or its first three letters; 0 for anything else.
unsigned month_named(const std::string& name) {
  static constexpr std::array<const char*, 12> months = {
      "january", "february", "march",     "april",   "may",      "june",
      "july",    "august",   "september", "october", "november", "december"};
  const std::string lower = lower_case(name);
  for (unsigned i = 0; i < months.size(); ++i)
    if (lower.size() >= 3 && std::string(months[i]).starts_with(lower)) return i + 1;
  return 0;
}

const std::regex& iso() {
  static const std::regex pattern(
      R"((\d{4})-(\d{2})-(\d{2})[T ](\d{2}):(\d{2})(?::(\d{2})(?:\.\d+)?)? ?(Z|UTC|[+-]\d{2}:?\d{2})?)");
  return pattern;
}

std::optional<Moment> iso_moment(const std::string& text, std::int64_t zone) {
  std::smatch m;
  if (!std::regex_match(text, m, iso())) return std::nullopt;
  const auto local = utc({number_in(m[1]), static_cast<unsigned>(number_in(m[2])),
                          static_cast<unsigned>(number_in(m[3])), number_in(m[4]), number_in(m[5]),
                          number_in(m[6])});
  constexpr std::int64_t farthest_zone = 14 * 3600 + 59 * 60;
  const std::int64_t ahead = m[7].matched ? zone_of(text) : zone;
  const bool is_zone = std::abs(ahead) <= farthest_zone;
  if (!local || !is_zone) return std::nullopt;
  return *local - ahead;
}

/// As Moodle writes it in English.
std::optional<Moment> spoken_moment(const std::string& text, std::int64_t zone) {
  static const std::regex pattern(
      R"((?:[A-Za-z]+, )?(\d{1,2}) ([A-Za-z]+) (\d{4}),? (\d{1,2}):(\d{2})(?::(\d{2}))? ?([AaPp][Mm])?)");
  std::smatch m;
  if (!std::regex_match(text, m, pattern)) return std::nullopt;
  int hour = number_in(m[4]);
  if (m[7].matched && (hour < 1 || hour > 12)) return std::nullopt;
  if (m[7].matched) hour = hour % 12 + (lower_case(m[7]) == "pm" ? 12 : 0);
  const auto local =
      utc({number_in(m[3]), month_named(m[2]), static_cast<unsigned>(number_in(m[1])), hour,
           number_in(m[5]), number_in(m[6])});
  if (!local) return std::nullopt;
  return *local - zone;
}

}  // namespace

bool names_zone(const std::string& text) {
  std::smatch m;
  return text.size() <= 100 && std::regex_match(text, m, iso()) && m[7].matched;
}

std::int64_t zone_of(const std::string& text) {
  static const std::regex pattern(R"(.*([+-])(\d{2}):?(\d{2}))");
  std::smatch m;
  if (!std::regex_match(text, m, pattern) || text.find(':') == std::string::npos) return 0;
  const std::int64_t ahead = number_in(m[2]) * 3600 + number_in(m[3]) * 60;
  return m[1] == "-" ? -ahead : ahead;
}

std::optional<Moment> exact_moment_of(const std::string& text) {
  static const std::regex exact(
      R"(\d{4}-\d{2}-\d{2}T\d{2}:\d{2}(:\d{2}(\.\d{1,9})?)?(Z|[+-]\d{2}:[0-5]\d))");
  constexpr std::size_t longest = 40;
  if (text.size() > longest || !std::regex_match(text, exact)) return std::nullopt;
  return iso_moment(text, 0);
}

std::optional<Moment> moment_of(const std::string& text, std::int64_t zone) {
  if (text.size() > 100) return std::nullopt;
  const std::optional<Moment> moment = iso_moment(text, zone);
  return moment ? moment : spoken_moment(text, zone);
}

}  // namespace tumble::judge
