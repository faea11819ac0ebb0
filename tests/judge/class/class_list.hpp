#pragma once
/// @file
/// The class as it was graded last, kept beside the records: a report is about these students, and
/// not about submissions that are gone.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "judge/class/lms.hpp"
#include "judge/class/student_record.hpp"

namespace tumble::judge {

struct ListedStudent {
  std::string student;
  bool absent = false;  ///< on the roster, and nothing was handed in
};

struct ClassList {
  Lms lms = Lms::none;
  std::vector<ListedStudent> students;
};

void write_class_list(const std::filesystem::path& file, const ClassList& list);

/// Nothing if there is no file.
/// @throws std::runtime_error naming the file if it cannot be understood
std::optional<ClassList> read_class_list(const std::filesystem::path& file);

}  // namespace tumble::judge
