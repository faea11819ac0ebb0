#pragma once
/// @file
/// All that a class has handed in: folders with a folder or an archive for each student, or what a
/// platform lets its instructors download.

#include <optional>
#include <string>
#include <vector>

#include "judge/build/work_folder.hpp"
#include "judge/class/lms.hpp"
#include "judge/class/rules.hpp"
#include "judge/class/submissions.hpp"

namespace tumble::judge {

/// What is no student's work, and why.
struct LeftOut {
  std::string what, why;
};

struct ClassWork {
  std::vector<Submission> submissions;  ///< by the students' names; a row each
  std::vector<LeftOut> left_out;        ///< every other entry of the folders
  Lms lms = Lms::none;                  ///< whose download it is
};

/// Collects what lies in these folders, or in a platform's zip: each folder and each archive in
/// them is a student's submission, or it is as the platform's names say.
/// @param from the platform; if not given, what the names say where they leave no doubt
/// @param several which submission counts where a student has more than one
/// @param work for what has to be unpacked
/// @throws std::invalid_argument if a folder does not exist or holds none, or two have one name
ClassWork collect(const Course& course, const std::vector<fs::path>& given,
                  const std::optional<Lms>& from, Several several, const WorkFolder& work);

}  // namespace tumble::judge
