#pragma once
/// @file
/// How ours stands to the others.

#include "project/bench/contact/problem.hpp"
#include "support/table.hpp"

namespace tumble::bench {

/// Each method's count of what it has right, and what that took.
support::Table counts_table(const Problem& problem, const std::vector<Curve>& curves);

/// One line: ours beside the other one with the least error; empty without others.
std::string standing(const Problem& problem, const std::vector<Curve>& curves);

}  // namespace tumble::bench
