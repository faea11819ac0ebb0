#include "judge/class/class_outputs.hpp"

#include <map>
#include <set>
#include <stdexcept>

#include "judge/class/class_list.hpp"
#include "judge/class/feedback.hpp"
#include "judge/class/grades.hpp"
#include "judge/class/identical_files.hpp"
#include "judge/class/lms_grades.hpp"
#include "judge/class/zip_file.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

namespace {

/// The path by which a platform gives feedback back.
std::string answer_path(const Submission& submission, Lms lms) {
  const bool is_moodles = submission.answer_under.find("_assignsubmission_") != std::string::npos;
  if (lms != Lms::moodle || is_moodles || submission.who.id.empty()) return submission.answer_under;
  // Handed in otherwise, and Moodle's number is known from its worksheet.
  return submission.who.name + "_" + submission.who.id + "_assignsubmission_file_/";
}

/// The same by student.
std::map<std::string, std::string> answer_paths(const GradedClass& graded) {
  std::map<std::string, std::string> paths;
  for (const Submission& submission : graded.submissions)
    paths[submission.student] = answer_path(submission, graded.lms);
  return paths;
}

/// Who was in the class when it was graded last.
std::vector<std::string> students_before(const GradesFolder& folder) {
  std::vector<std::string> students;
  try {
    if (const auto list = read_class_list(folder.class_list()))
      for (const ListedStudent& each : list->students) students.push_back(each.student);
  } catch (const std::runtime_error&) {  // it is written anew
  }
  return students;
}

fs::path feedback_file(const GradesFolder& folder, const std::string& student, const char* ending) {
  return folder.feedback() / (file_name_for(student) + ending);
}

/// Of submissions that are gone. Nothing else in the folder is ours to remove.
void remove_old_feedback(const GradesFolder& folder, const GradedClass& graded) {
  std::set<std::string> now;
  for (const StudentRecord& record : graded.records) now.insert(record.student);
  for (const std::string& student : students_before(folder))
    for (const char* ending : {".html", ".txt"})
      if (!now.contains(student)) fs::remove(feedback_file(folder, student, ending));
}

/// A text and a page for each student, and all of them in a zip.
void write_feedback(const GradesFolder& folder, const GradedClass& graded) {
  const auto under = answer_paths(graded);
  std::map<std::string, std::string> zipped;
  remove_old_feedback(folder, graded);
  for (const StudentRecord& record : graded.records) {
    const std::pair<const char*, std::string> answers[] = {
        {".html", feedback_html(graded.settings, record)},
        {".txt", feedback_text(graded.settings, record)}};
    for (const auto& [ending, text] : answers) {
      support::write_text_and_folders(feedback_file(folder, record.student, ending), text);
      const auto path = under.find(record.student);
      if (path != under.end() && !path->second.empty())
        zipped[path->second + "feedback" + ending] = text;
    }
  }
  if (can_write_zip() && !zipped.empty()) write_zip(folder.path / "feedback.zip", zipped);
}

void write_list(const GradesFolder& folder, const GradedClass& graded) {
  ClassList list{graded.lms, {}};
  for (const StudentRecord& record : graded.records)
    list.students.push_back({record.student, record.absent});
  write_class_list(folder.class_list(), list);
}

}  // namespace

std::vector<fs::path> write_outputs(const GradesFolder& folder, const GradedClass& graded) {
  std::vector<fs::path> written = {folder.csv(), folder.junit()};
  support::write_text(folder.csv(), grades_csv(graded.settings, graded.records));
  support::write_text(folder.junit(), grades_junit(graded.settings, graded.records));
  const std::string for_lms =
      lms_grades(graded.lms, graded.settings, graded.records, graded.roster);
  if (!for_lms.empty()) {
    written.push_back(folder.path / (name_of(graded.lms) + ".csv"));
    support::write_text(written.back(), for_lms);
  }
  support::write_text(folder.path / "identical.csv",
                      identical_csv(identical_files(graded.settings, graded.records)));
  write_feedback(folder, graded);
  write_list(folder, graded);
  return written;
}

}  // namespace tumble::judge
