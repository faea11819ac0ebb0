#pragma once
/// @file
/// A class's work, made up: what students of different talents and tempers would hand in.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "judge/course/course.hpp"

namespace tumble::bench {

namespace fs = std::filesystem;

/// What a file is.
enum class Kind { solution, mistake, untouched, no_program, attack, odd };
inline constexpr std::size_t kinds = 6;

std::string name_of(Kind kind);

/// A student: which kind each unit's file is.
struct Student {
  std::string name;
  std::map<std::string, Kind> files;  ///< by the unit's id, such as "04_quaternions/product"
  bool as_archive = false;
};

/// A class whose files lie on disk.
struct HandedIn {
  fs::path submissions;  ///< as they were handed in: folders and archives
  fs::path sources;      ///< the same, a folder a student: <student>/04_quaternions/product.cpp
  std::vector<Student> students;
};

/// What attacks need from who runs them.
struct Attacks {
  fs::path folder;    ///< tests/project/attacks
  fs::path root;      ///< the tree that is attacked
  fs::path writable;  ///< where every user may write
};

/// Makes a class below `place`. The same seed makes the same class.
/// Two of three students have worked on all units, the others on the first ones only; what is not
/// touched is the stub. Of what they worked on, three quarters is right, most of the rest is wrong.
/// Every file but the stubs begins with its student's name, so that no two of them are the same.
HandedIn hand_in(const judge::Course& course, const std::vector<judge::Unit>& units,
                 const Attacks& attacks, const fs::path& place, std::size_t students,
                 std::uint64_t seed);

}  // namespace tumble::bench
