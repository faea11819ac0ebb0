#include "judge/class/iso_time.hpp"

#include <chrono>
#include <regex>

namespace tumble::judge {

std::optional<std::int64_t> moment_of(const std::string& text) {
  static const std::regex iso(
      R"((\d{4})-(\d{2})-(\d{2})T(\d{2}):(\d{2})(?::(\d{2})(?:\.\d{1,9})?)?)"
      R"((?:Z|([+-])(\d{2}):(\d{2})))");
  std::smatch part;
  if (text.size() > 40 || !std::regex_match(text, part, iso)) return std::nullopt;
  const auto number = [&](std::size_t i) { return part[i].matched ? std::stoi(part[i]) : 0; };
  const std::chrono::year_month_day day(std::chrono::year(number(1)),
                                        std::chrono::month(static_cast<unsigned>(number(2))),
                                        std::chrono::day(static_cast<unsigned>(number(3))));
  const bool is_time = number(4) < 24 && number(5) < 60 && number(6) < 60;
  const bool is_zone = number(8) <= 14 && number(9) < 60;
  if (!day.ok() || !is_time || !is_zone) return std::nullopt;
  const int east = (part[7] == "-" ? -1 : 1) * (60 * number(8) + number(9));
  const std::int64_t days = std::chrono::sys_days(day).time_since_epoch().count();
  return ((days * 24 + number(4)) * 60 + number(5) - east) * 60 + number(6);
}

}  // namespace tumble::judge
