#pragma once
/// @file
/// Where this judge's course is described: the build writes it, and the place is the only path that
/// is compiled into a judge's commands.

namespace tumble::judge {

extern const char* const course_file;

}  // namespace tumble::judge
