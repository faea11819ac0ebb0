#pragma once
/// @file
/// Specs are modules, so that a student waits for the build of one exercise only.

#include "judge/course/course.hpp"

namespace tumble::judge {

/// Makes the laws and misconceptions of a unit known to doctest and to the judge; once is enough. A
/// unit without a module has none, or is known already.
/// @throws std::runtime_error if the module is not built
void load_spec(const Unit& unit);

}  // namespace tumble::judge
