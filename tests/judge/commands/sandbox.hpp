#pragma once
/// @file
/// Which walls of the sandbox stand on this machine, for this course.

#include <vector>

#include "judge/course/course.hpp"
#include "judge/sandbox/walls.hpp"

namespace tumble::judge {

/// The walls that are missing around a worker or around the compiler. The compiler of a judge that
/// root has started is another user only if other users may enter the course's folders.
std::vector<MissingWall> missing_walls(const Course& course);

/// Whose code is judged.
enum class Strangers {
  no,        ///< students judge their own: another user for it would be too much
  yes,       ///< every missing wall is said
  strictly,  ///< nothing is judged if one is missing
};

/// Says on stderr which walls are missing, and whether no process can be confined at all.
/// @return whether judging may go on
bool may_judge(const Course& course, Strangers strangers);

}  // namespace tumble::judge
