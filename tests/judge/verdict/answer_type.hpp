#pragma once
/// @file
/// What an answer is by its contract. As values, a struct of six numbers and a vector of six look
/// the same.

#include <string>
#include <vector>

#include "judge/course/course.hpp"

namespace tumble::judge {

/// Whether an answer is a struct, and what its parts are called.
struct AnswerType {
  std::vector<std::string> members = {};  ///< of a struct: "a", "aa"; empty if it is none
  bool has_structs_in_list = false;       ///< "std::vector<Pair>"

  bool is_plain() const { return members.empty() && !has_structs_in_list; }
};

/// What the contract says of a unit's answer.
AnswerType answer_type(const Course& course, const Unit& unit);

}  // namespace tumble::judge
