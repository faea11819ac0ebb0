#pragma once
/// @file
/// What is to be done for one exercise of one student.

#include <filesystem>

#include "judge/course/course.hpp"

namespace tumble::judge {

/// A student's file for a unit, and the folder where what it needs is built. It keeps references:
/// course and unit outlive it.
struct Job {
  const Course& course;
  const Unit& unit;
  std::filesystem::path source;  ///< the student's file
  std::filesystem::path folder;  ///< made where it is needed
};

}  // namespace tumble::judge
