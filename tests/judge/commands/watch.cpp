#include <chrono>
#include <iostream>
#include <map>
#include <thread>

#include "judge/commands/commands.hpp"

namespace tumble::judge {

int watch(const Course& course) {
  using namespace std::chrono_literals;
  const auto saved_at = [&](const Unit& unit) {
    std::error_code missing;  // an editor may be replacing it right now
    return fs::last_write_time(course.exercise(unit), missing);
  };
  std::map<std::string, fs::file_time_type> seen;
  for (const Unit& unit : course.units) seen[unit.id()] = saved_at(unit);
  std::cout << "Watching " << fs::relative(course.root / "exercises").string()
            << ": save a file and it is judged. Ctrl-C ends.\n"
            << std::flush;
  while (true) {
    for (const Unit& unit : course.units) {
      const fs::file_time_type now = saved_at(unit);
      if (now == seen[unit.id()] || now == fs::file_time_type::min()) continue;
      seen[unit.id()] = now;
      std::cout << "\n";
      CheckOptions options;
      options.what = unit.number;
      check(course, options);
      std::cout << std::flush;
    }
    std::this_thread::sleep_for(100ms);
  }
}

}  // namespace tumble::judge
