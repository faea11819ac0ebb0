#pragma once
/// @file
/// A function of an engine, compiled; or the solution in its place.

#include <string>

#include "judge/build/object_cache.hpp"
#include "judge/mine/engine_build.hpp"

namespace tumble::judge::mine {

/// A part and its object.
struct Compiled {
  Part part;
  fs::path object;  ///< empty if there is none, not even the solution's
};

/// Compiles the student's file behind the judge's walls. Where that fails, or nothing is written,
/// the solution takes its place.
/// @param folder  for what is built
/// @param earlier what was compiled before, if anything
Compiled compile(const Course& course, Part part, const fs::path& folder,
                 const ObjectCache* earlier);

/// Puts the solution in a part's place.
/// @param why    in a few words
/// @param folder for what is built, where the course has solutions as sources only
void take_solution(const Course& course, Compiled& part, const std::string& why,
                   const fs::path& folder);

}  // namespace tumble::judge::mine
