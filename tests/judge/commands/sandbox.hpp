#pragma once
/// @file
/// Which walls of the sandbox stand on this machine, for this course.

#include <vector>

#include "judge/course/course.hpp"
#include "judge/sandbox/confinement.hpp"

namespace tumble::judge {

/// The walls that are missing around a worker or around the compiler. The compiler of a judge that
/// root has started is another user only if other users may enter the course's folders.
std::vector<MissingLayer> missing_walls(const Course& course);
/// Says which walls are missing; if not strict, no word about that of another user: a student runs
/// their own code.
/// @return whether all of them stand
bool report_missing_walls(const Course& course, bool strict);

}  // namespace tumble::judge
