#pragma once
/// @file
/// How right simulate() was on many scenes: the distribution of true errors per asked and per
/// stated ones.

#include <algorithm>
#include <string>
#include <vector>

#include "project/harness/honesty.hpp"
#include "support/table.hpp"

namespace tumble::test {

/// Ratios, sorted.
class Distribution {
 public:
  explicit Distribution(std::vector<double> ratios) : sorted_(std::move(ratios)) {
    std::sort(sorted_.begin(), sorted_.end());
  }
  std::size_t size() const { return sorted_.size(); }
  double part(double share) const {
    if (sorted_.empty()) return 0;
    return sorted_[static_cast<std::size_t>(share * static_cast<double>(sorted_.size() - 1))];
  }
  double above(double limit) const {
    return static_cast<double>(sorted_.end() -
                               std::upper_bound(sorted_.begin(), sorted_.end(), limit));
  }

 private:
  std::vector<double> sorted_;
};

/// Of the answers that reached what was asked: true error per asked. Of all: per stated.
inline Distribution per_asked(const std::vector<Answer>& answers) {
  std::vector<double> ratios;
  for (const Answer& a : answers)
    if (a.refused.empty() && a.reached) ratios.push_back(a.per_asked());
  return Distribution(ratios);
}
inline Distribution per_stated(const std::vector<Answer>& answers) {
  std::vector<double> ratios;
  for (const Answer& a : answers)
    if (a.refused.empty()) ratios.push_back(a.per_stated());
  return Distribution(ratios);
}

inline void add_row(support::Table& table, const std::string& name,
                    const std::vector<Answer>& answers) {
  if (answers.empty()) return;
  const Distribution asked = per_asked(answers), stated = per_stated(answers);
  using support::number;
  const auto refused = answers.size() - stated.size();
  table.add({name, number(static_cast<double>(answers.size())),
             number(static_cast<double>(stated.size() - asked.size())),
             number(static_cast<double>(refused)), number(asked.part(0.5), 2),
             number(asked.part(0.99), 2), number(asked.part(1), 2), number(asked.above(1)),
             number(stated.part(0.5), 2), number(stated.part(0.99), 2), number(stated.part(1), 2),
             number(stated.above(1)), number(stated.above(10))});
}

/// The distribution of true/asked and true/stated, of all answers and of kinds of them.
inline support::Table honesty_table(const std::vector<Answer>& answers) {
  support::Table table({"scenes", "number", "not reached", "refused", "true/asked: median", "99 %",
                        "largest", "> 1", "true/stated: median", "99 %", "largest", "> 1", "> 10"});
  const auto add = [&](const std::string& name, const auto& belongs) {
    std::vector<Answer> some;
    for (const Answer& a : answers)
      if (belongs(a)) some.push_back(a);
    add_row(table, name, some);
  };
  add("all", [](const Answer&) { return true; });
  add("no force", [](const Answer& a) {
    return !a.scene.any_force() && a.scene.steady.at_point.empty() &&
           a.scene.steady.angular_drag == 0;
  });
  add("steady forces", [](const Answer& a) {
    return !a.scene.any_force() &&
           !(a.scene.steady.at_point.empty() && a.scene.steady.angular_drag == 0);
  });
  add("any force", [](const Answer& a) { return a.scene.any_force() && a.scene.pulses.empty(); });
  add("pulses", [](const Answer& a) { return !a.scene.pulses.empty(); });
  add("springs", [](const Answer& a) { return !a.scene.springs.empty(); });
  for (const char* kind : {"any", "top", "near-top", "plate", "ball", "near-ball", "needle"})
    add(kind, [&](const Answer& a) { return a.scene.body_kind == kind; });
  add("turned axes", [](const Answer& a) { return a.scene.turned(); });
  return table;
}

}  // namespace tumble::test
