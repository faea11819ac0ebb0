#pragma once
/// @file
/// The files of a student that are given in a folder.

#include "judge/course/course.hpp"

namespace tumble::judge {

/// The file of a unit in a folder of files: DIR/04_quaternions/product.cpp or DIR/product.cpp.
fs::path file_in(const fs::path& folder, const Unit& unit);

}  // namespace tumble::judge
