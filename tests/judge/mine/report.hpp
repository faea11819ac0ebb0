#pragma once
/// @file
/// What is said about an engine: on the console, as a figure, and as JSON for other programs.

#include <iosfwd>
#include <string>
#include <vector>

#include "judge/mine/engine_build.hpp"
#include "judge/mine/measure.hpp"

namespace tumble::judge::mine {

/// The functions that are missing, and what to do next.
void print_missing(std::ostream& out, const Course& course, const EngineBuild& build);
/// Whose functions the engine is made of.
void print_parts(std::ostream& out, const EngineBuild& build);
/// What the die lacks, where the engine is there without it.
void print_waiting(std::ostream& out, const Course& course, const std::vector<Part>& waiting);
/// The tables of numbers.
void print_measurement(std::ostream& out, const EngineBuild& build, const Measurement& measurement);

/// Error against time, the student's curves beside the library's; and how late the die's impacts
/// come, if there is one. A complete SVG document.
std::string figure_of(const EngineBuild& build, const Measurement& measurement);

/// Everything, as JSON text.
/// @param measurement null if the engine was not built
/// @param waiting     what the die lacks
std::string json_of(const EngineBuild& build, const Measurement* measurement,
                    const std::vector<Part>& waiting, const std::vector<std::string>& findings);

/// "4.8 quaternion_dot, 9.4 dydt"
std::string names_of(const std::vector<Part>& parts);
/// Whose function this unit is, for a curve's name: "your RK4", "solution's RK4".
std::string owner_of(const EngineBuild& build, const std::string& number);

}  // namespace tumble::judge::mine
