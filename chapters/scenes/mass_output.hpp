#pragma once
/// @file
/// What `./tumble mass` has found out, as JSON and as tables.

#include <string>
#include <vector>

#include "scenes/json.hpp"
#include "scenes/mass_answer.hpp"

namespace tumble::scenes {

/// The point that --about gives.
inline Vec3 point_of(const std::vector<double>& about) { return {about[0], about[1], about[2]}; }

/// Everything, with all digits.
Json answer_json(const MassAnswer& found, const MassCommand& command);

/// What was found, a sentence each, and whether vertices were welded.
std::vector<std::string> sentences(const MassAnswer& found);

/// Prints one file: its findings, its parts if it has some, and all about the whole.
void print(const MassAnswer& found, const MassCommand& command);

/// Prints several files, one line each, and below it one for each of its parts.
void print_table(const std::vector<MassAnswer>& all);

}  // namespace tumble::scenes
