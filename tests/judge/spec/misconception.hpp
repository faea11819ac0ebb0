#pragma once
/// @file
/// Named wrong answers. When an answer is wrong, the judge looks which misconception gives the same
/// numbers to every question of the unit so far, and evaluates given functions where the student
/// does, and says so.

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "judge/protocol/finding.hpp"

namespace tumble::judge {

/// What is said about each misconception of `unit`, in the order of its spec.
std::vector<Misconception>& misconceptions_of(const std::string& unit);

template <class Signature>
struct MisconceivedFunction;

/// A mistake that students make, as another body of the same function.
template <class Result, class... Arguments>
struct MisconceivedFunction<Result(Arguments...)> {
  std::string name;      ///< short: "operands swapped"
  std::string sentence;  ///< what happened, and where to look; no formula that solves the unit
  std::string section;   ///< heading of the chapter's page that explains it
  std::function<Result(Arguments...)> body;
};

/// The misconceptions of one unit: a spec defines one object of this type.
template <class Signature>
class Misconceptions {
 public:
  Misconceptions(const std::string& unit, std::vector<MisconceivedFunction<Signature>> list) {
    for (const auto& [name, sentence, section, body] : list)
      misconceptions_of(unit).push_back({name, sentence, section});
    of(unit) = std::move(list);
  }
  static std::vector<MisconceivedFunction<Signature>>& of(const std::string& unit) {
    static std::map<std::string, std::vector<MisconceivedFunction<Signature>>> registry;
    return registry[unit];
  }
};

}  // namespace tumble::judge
