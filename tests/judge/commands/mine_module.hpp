#pragma once
/// @file
/// ./tumble mine is a module: it needs most of the library, and only those who ask for it build it.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "judge/commands/commands.hpp"
#include "judge/course/course.hpp"

namespace tumble::judge {

/// What the module offers, under the name tumble_mine_module.
struct MineModule {
  /// The command.
  int (*command)(const Course& course, const MineOptions& options);
  /// The figure that goes with a grade: see mine/travelling_curve.hpp.
  std::optional<std::string> (*travelling_curve)(const Course& course,
                                                 const std::function<fs::path(const Unit&)>& source,
                                                 const fs::path& folder);
};

/// @throws std::runtime_error if it is not built, or the tree has no whole course to make an engine
///         of
const MineModule& mine_module(const Course& course);

}  // namespace tumble::judge
