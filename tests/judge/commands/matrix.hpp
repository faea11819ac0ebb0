#pragma once
/// @file
/// The kill matrix: does every spec fail every one of its misconceptions, and name it?

#include <cstdint>
#include <iosfwd>
#include <vector>

#include "judge/course/course.hpp"

namespace tumble::judge {

/// Runs the spec of every unit against each of its misconceptions, and prints a Markdown table.
/// @return whether each of them failed, was named and none besides it, is explained by a section of
///         the chapter's page (if there is one), and there are at least four
bool print_kill_matrix(std::ostream& out, const Course& course, const std::vector<Unit>& units,
                       std::uint64_t seed);

}  // namespace tumble::judge
