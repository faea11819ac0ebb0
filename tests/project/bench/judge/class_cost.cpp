#include "project/bench/judge/class_cost.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "judge/class/progress_line.hpp"

namespace tumble::bench {

support::Table cost_by_cores(const MeasuredCost& measured) {
  constexpr std::array<std::size_t, 4> classes = {30, 200, 1000, 5000};
  constexpr std::array<std::size_t, 5> computed = {4, 16, 64, 200, 1000};
  const auto count = static_cast<double>(measured.students);
  std::vector<std::string> headings = {"students", "processor time", "1 core", "2 cores"};
  for (const std::size_t cores : computed) headings.push_back(std::to_string(cores));
  support::Table table(headings);
  for (const std::size_t students : classes) {
    const double times = static_cast<double>(students) / count;
    std::vector<std::string> row = {std::to_string(students)};
    for (const double seconds : {measured.processor, measured.one_core, measured.two_cores})
      row.push_back(judge::duration_text(times * seconds));
    for (const std::size_t cores : computed)
      row.push_back(judge::duration_text(times * measured.two_cores * 2 /
                                         static_cast<double>(std::min(cores, students))));
    table.add(row);
  }
  return table;
}

}  // namespace tumble::bench
