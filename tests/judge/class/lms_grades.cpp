#include "judge/class/lms_grades.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "judge/class/canonical_names.hpp"
#include "judge/class/feedback.hpp"
#include "judge/class/final_grade.hpp"

namespace tumble::judge {

namespace {

/// A column's values for a student.
using Cells = std::map<std::string, std::string>;

/// Empty where there are none to be given away yet: no points are not zero points.
std::string final_points(const CourseSettings& settings, const StudentRecord& record) {
  const FinalGrade grade = final_grade(settings, record);
  if ((record.absent && !grade.by_hand) || !is_complete(settings, record)) return "";
  return points_text(grade.points);
}

/// What Moodle does not know, it does not take: "Identifier", "Grade" and "Last modified (grade)".
Cells moodle_cells(const CourseSettings& settings, const StudentRecord& record) {
  Cells cells{{"Identifier", "Participant " + record.who.id},
              {"Full name", record.who.name},
              {"Email address", record.who.email},
              {"Maximum Grade", points_text(settings.most())},
              {"Last modified (grade)", "-"}};
  cells["Grade"] = final_points(settings, record);
  if (cells["Grade"].empty()) return cells;
  cells["Feedback comments"] = feedback_comment(settings, record);
  return cells;
}

Cells gradescope_cells(const CourseSettings& settings, const StudentRecord& record) {
  return {{"Name", record.who.name.empty() ? record.student : record.who.name},
          {"SID", record.who.id},
          {"Email", record.who.email},
          {"Total Score", final_points(settings, record)},
          {"Max Points", points_text(settings.most())},
          {"Status", record.absent ? "Missing" : "Graded"},
          {"Submission Time", record.handed_in}};
}

/// A table with these columns: the roster's rows first, then the students that it does not list.
class GradeTable {
 public:
  GradeTable(const std::vector<std::string>& columns, const Roster* own) {
    if (own) {
      table_ = own->table;
      for (const Member& member : own->members) row_of_[member.who.id] = member.row;
    }
    for (const std::string& column : columns)
      if (!number_of(column)) add_column(column);
  }

  /// Writes the cells into the row of this number, or into a new one. What is there stays, but for
  /// the columns to be overwritten.
  void fill(const std::string& id, const Cells& cells,
            const std::vector<std::string>& overwritten) {
    auto [found, is_new] = row_of_.try_emplace(id, table_.rows.size());
    if (is_new || id.empty()) {
      found->second = table_.rows.size();
      table_.rows.emplace_back(table_.header.size());
    }
    std::vector<std::string>& row = table_.rows[found->second];
    for (const auto& [column, text] : cells) {
      std::string& cell = row[*number_of(column)];
      const bool over =
          std::find(overwritten.begin(), overwritten.end(), column) != overwritten.end();
      if (cell.empty() || (over && !text.empty())) cell = without_formula(text);
    }
  }

  std::string text() const { return table_.text(); }

 private:
  std::optional<std::size_t> number_of(const std::string& column) const {
    for (std::size_t i = 0; i < table_.header.size(); ++i)
      if (table_.header[i] == column) return i;
    return std::nullopt;
  }
  void add_column(const std::string& column) {
    table_.header.push_back(column);
    for (auto& row : table_.rows) row.emplace_back();
  }
  CsvTable table_;
  std::map<std::string, std::size_t> row_of_;
};

std::string moodle_grades(const CourseSettings& settings, const std::vector<StudentRecord>& records,
                          const Roster* roster) {
  GradeTable table({"Identifier", "Full name", "Email address", "Grade", "Maximum Grade",
                    "Last modified (grade)", "Feedback comments"},
                   roster);
  for (const StudentRecord& record : records)
    if (!record.who.id.empty())
      table.fill(record.who.id, moodle_cells(settings, record), {"Grade", "Feedback comments"});
  return table.text();
}

std::string gradescope_grades(const CourseSettings& settings,
                              const std::vector<StudentRecord>& records) {
  std::vector<std::string> columns = {"Name",       "SID",    "Email",          "Total Score",
                                      "Max Points", "Status", "Submission Time"};
  const auto of_unit = [&](const Unit& unit) {
    return unit.number + " " + unit.name + " (" + points_text(settings.points(unit)) + ")";
  };
  for (const Unit& unit : settings.units) columns.push_back(of_unit(unit));
  GradeTable table(columns, nullptr);
  for (const StudentRecord& record : records) {
    Cells cells = gradescope_cells(settings, record);
    for (const Unit& unit : settings.units)
      if (record.find(unit))
        cells[of_unit(unit)] = points_text(unit_points(settings, record, unit));
    table.fill("", cells, {});
  }
  return table.text();
}

/// The column of an assignment in Canvas's gradebook: "Homework 1 (98765)".
std::string canvas_column(const CourseSettings& settings, const Roster* roster) {
  const std::string title = canonical(settings.title);
  if (roster)
    for (const std::string& column : roster->table.header) {
      const std::string name = canonical(column);
      if (name == title || (name.starts_with(title + " (") && name.ends_with(")"))) return column;
    }
  return settings.title;
}

/// What Canvas knows a student by: its gradebook's columns up to "Section", or the fewest that it
/// takes.
std::vector<std::string> canvas_columns(const Roster* roster) {
  if (!roster) return {"Student", "ID", "Section"};
  const std::vector<std::string>& all = roster->table.header;
  return {
      all.begin(),
      all.begin() + static_cast<std::ptrdiff_t>(roster->table.column({"section"}).value_or(1)) + 1};
}

std::vector<std::string> canvas_row(const CourseSettings& settings, const StudentRecord& record,
                                    const Roster* roster, std::size_t columns) {
  std::vector<std::string> row(columns);
  row[0] = without_formula(record.who.name);
  row[1] = record.who.id;
  if (roster)
    for (const Member& member : roster->members)
      if (member.who.id == record.who.id) row = roster->table.rows[member.row];
  row.resize(columns);
  row.push_back(final_points(settings, record));
  return row;
}

std::string canvas_grades(const CourseSettings& settings, const std::vector<StudentRecord>& records,
                          const Roster* roster) {
  CsvTable table;
  table.header = canvas_columns(roster);
  const std::size_t columns = table.header.size();
  table.header.push_back(canvas_column(settings, roster));
  std::vector<std::string> possible(columns + 1);
  possible.front() = "    Points Possible";
  possible.back() = points_text(settings.most());
  table.rows.push_back(std::move(possible));
  for (const StudentRecord& record : records)
    if (!record.who.id.empty()) table.rows.push_back(canvas_row(settings, record, roster, columns));
  return table.text();
}

}  // namespace

std::string lms_grades(Lms lms, const CourseSettings& settings,
                       const std::vector<StudentRecord>& records, const Roster* roster) {
  const Roster* own = roster && roster->lms == lms ? roster : nullptr;
  switch (lms) {
    case Lms::moodle:
      return moodle_grades(settings, records, own);
    case Lms::canvas:
      return canvas_grades(settings, records, own);
    case Lms::gradescope:
      return gradescope_grades(settings, records);
    case Lms::none:
      break;
  }
  return "";
}

}  // namespace tumble::judge
