#include "judge/class/class_outputs.hpp"

#include <map>

#include "judge/class/class_list.hpp"
#include "judge/class/feedback.hpp"
#include "judge/class/grades.hpp"
#include "judge/class/identical_files.hpp"
#include "judge/class/lms_grades.hpp"
#include "judge/class/zip_file.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

namespace {

/// The paths by which a platform gives feedback back, by student.
std::map<std::string, std::string> answers_under(const std::vector<Submission>& submissions) {
  std::map<std::string, std::string> paths;
  for (const Submission& submission : submissions)
    paths[submission.student] = submission.answer_under;
  return paths;
}

/// A text and a page for each student, and all of them in a zip.
void write_feedback(const GradesFolder& folder, const GradedClass& graded) {
  const auto under = answers_under(graded.submissions);
  std::map<std::string, std::string> zipped;
  fs::remove_all(folder.feedback());  // of submissions that are gone
  for (const StudentRecord& record : graded.records) {
    const std::pair<const char*, std::string> answers[] = {
        {".html", feedback_html(graded.settings, record)},
        {".txt", feedback_text(graded.settings, record)}};
    for (const auto& [ending, text] : answers) {
      support::write_text_and_folders(folder.feedback() / (file_name_for(record.student) + ending),
                                      text);
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
