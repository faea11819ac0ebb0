#include "project/bench/dynamics/honesty.hpp"

#include <iostream>

#include "project/harness/honesty_table.hpp"

namespace tumble::bench {

Honesty honesty(int scenes) {
  std::vector<test::Answer> answers;
  int unknown = 0;
  std::string broken;
  for (int i = 1; i <= scenes; ++i) {
    if (i % 100 == 0) std::cerr << "tumble: honesty: scene " << i << '\n';
    const auto answer = test::answer_for(test::motion_scene(static_cast<std::uint64_t>(i)));
    if (!answer) {
      ++unknown;
      continue;
    }
    if (answer->refused.empty() && !(answer->per_stated() <= 10))
      broken += "; scene " + std::to_string(i) + " is " + support::number(answer->per_stated(), 2) +
                " times as wrong as stated";
    answers.push_back(*answer);
  }
  if (!(test::per_asked(answers).part(0.99) <= 1))
    broken += "; of what is said to be reached, more than 1 % is not";
  return {test::honesty_table(answers), unknown, broken};
}

}  // namespace tumble::bench
