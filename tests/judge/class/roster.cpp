#include "judge/class/roster.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "judge/class/canonical_names.hpp"
#include "judge/class/file_names.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

using ColumnNames = std::vector<std::string>;

const ColumnNames id_columns = {"identifier", "sid", "student id", "user id", "participant", "id"};
const ColumnNames name_columns = {"full name", "student", "student name", "name"};
const ColumnNames first_name_columns = {"first name", "firstname", "given name"};
const ColumnNames last_name_columns = {"last name", "lastname", "surname", "family name"};
const ColumnNames email_columns = {"email address", "email", "e-mail", "e-mail address"};
const ColumnNames login_columns = {"sis login id", "login",           "username", "user",
                                   "github",       "github username", "folder"};
const ColumnNames time_columns = {"last modified (submission)", "submission time", "submitted at",
                                  "handed in"};

std::string digits_at_the_end(const std::string& text) {
  const std::size_t last = text.find_last_not_of("0123456789");
  return last == std::string::npos ? text : text.substr(last + 1);
}

/// "Ann Lee" for "Lee, Ann"; empty for a name without a comma.
std::string turned(const std::string& name) {
  const std::size_t comma = name.find(',');
  return comma == std::string::npos ? "" : name.substr(comma + 1) + " " + name.substr(0, comma);
}

Lms lms_of(const CsvTable& table) {
  if (table.column({"identifier"})) return Lms::moodle;
  const bool canvas = table.header.size() > 3 && table.header[0] == "Student" &&
                      table.header[1] == "ID" && table.column({"section"});
  if (canvas) return Lms::canvas;
  return table.column({"sid"}) && table.column({"email"}) ? Lms::gradescope : Lms::none;
}

const std::string& name_for_people(const Identity& who) {
  return !who.name.empty() ? who.name : !who.email.empty() ? who.email : who.id;
}

/// Reads the members out of the table.
class RosterReader {
 public:
  RosterReader(Roster& roster, const std::string& name) : roster_(roster), name_(name) {}

  void read() {
    for (std::size_t i = 0; i < roster_.table.rows.size(); ++i) {
      const Member member = member_in(i);
      const bool nobody = member.who.name.empty() && member.who.id.empty() &&
                          member.who.email.empty() && member.login.empty();
      if (!nobody && !is_canvas_own(i) && is_new(member)) roster_.members.push_back(member);
    }
  }

 private:
  std::string cell(std::size_t row, const ColumnNames& columns) const {
    const auto column = roster_.table.column(columns);
    return column ? roster_.table.rows[row][*column] : "";
  }

  Member member_in(std::size_t row) const {
    Member member;
    member.row = row;
    member.who.name = cell(row, name_columns);
    const std::string first = cell(row, first_name_columns), last = cell(row, last_name_columns);
    if (member.who.name.empty())
      member.who.name = first + (first.empty() || last.empty() ? "" : " ") + last;
    member.who.name = canonical(member.who.name);
    member.who.id = cell(row, id_columns);
    if (roster_.lms == Lms::moodle) member.who.id = digits_at_the_end(member.who.id);
    member.who.email = cell(row, email_columns);
    member.login = cell(row, login_columns);
    member.handed_in = cell(row, time_columns);
    if (member.handed_in == "-") member.handed_in.clear();
    return member;
  }

  /// A student who is there twice, in two sections of a course, is one; two with one number are
  /// not.
  bool is_new(const Member& member) {
    if (member.who.id.empty()) return true;
    const auto [found, is_first] = of_id_.try_emplace(member.who.id, member);
    const Identity &one = found->second.who, &other = member.who;
    require(is_first || (one.name == other.name && one.email == other.email), name_,
            " has the number ", escaped(other.id), " twice, of ", escaped(one.name), " and of ",
            escaped(other.name), ": we could not tell whose grade is whose");
    return is_first;
  }

  /// Canvas's rows for the points and for a student that is not one.
  bool is_canvas_own(std::size_t row) const {
    const std::string& first = roster_.table.rows[row].front();
    return roster_.lms == Lms::canvas && (first.find("Points Possible") != std::string::npos ||
                                          first == "Student, Test" || cell(row, {"id"}).empty());
  }

  Roster& roster_;
  const std::string& name_;
  std::map<std::string, Member> of_id_;
};

}  // namespace

MemberFinder::MemberFinder(const Roster& roster) {
  for (const Member& member : roster.members) {
    by_id_.try_emplace(member.who.id, &member);
    const std::string& email = member.who.email;
    for (const std::string& name : {member.who.name, turned(member.who.name), member.who.id, email,
                                    member.login, email.substr(0, email.find('@'))})
      by_name_[letters_of(name)].insert(&member);
  }
}

const Member* MemberFinder::find(const Submission& submission) const {
  const auto with_id = by_id_.find(submission.who.id);
  if (!submission.who.id.empty() && with_id != by_id_.end()) return with_id->second;
  const std::set<const Member*> named = all_named(submission);
  return named.size() == 1 ? *named.begin() : nullptr;  // of two of one name neither
}

std::set<const Member*> MemberFinder::all_named(const Submission& submission) const {
  std::set<const Member*> named;
  for (const std::string* name : {&submission.student, &submission.who.name, &submission.who.email})
    if (const auto found = by_name_.find(letters_of(*name));
        found != by_name_.end() && !found->first.empty())
      named.insert(found->second.begin(), found->second.end());
  return named;
}

Roster read_roster(const std::filesystem::path& file) {
  return roster_in(support::read_text(file), file.string());
}

Roster roster_in(const std::string& text, const std::string& name) {
  Roster roster;
  roster.table = read_csv(text, name);
  roster.lms = lms_of(roster.table);
  RosterReader(roster, name).read();
  std::string columns;
  for (const std::string& column : roster.table.header)
    columns += (columns.empty() ? "" : ", ") + column;
  require(!roster.members.empty(), name,
          " names nobody: it needs a column called name, email or id; it has: ", columns);
  return roster;
}

RosterMatch match(const Roster& roster, std::vector<Submission>& submissions) {
  RosterMatch result;
  std::map<std::size_t, std::string> handed_in;  // whose work, by the row of the table
  const MemberFinder members(roster);
  for (Submission& submission : submissions) {
    const Member* member = members.find(submission);
    if (!member) {
      const bool several = members.all_named(submission).size() > 1;
      result.strangers.push_back(submission.student +
                                 (several ? ": this means several there, so it counts for none"
                                          : spelling_doubt(submission.student)));
      continue;
    }
    const std::string& first = handed_in.try_emplace(member->row, submission.student).first->second;
    require(first == submission.student, "the submissions ", escaped(first), " and ",
            escaped(submission.student), " are of one student on the roster, ",
            escaped(name_for_people(member->who)),
            ": remove one of them, or give both one name and say in course.json by "
            "\"several\" which counts");
    if (!member->who.name.empty()) submission.who.name = member->who.name;
    if (!member->who.id.empty()) submission.who.id = member->who.id;
    if (!member->who.email.empty()) submission.who.email = member->who.email;
    if (submission.handed_in.empty()) submission.handed_in = member->handed_in;
  }
  std::copy_if(roster.members.begin(), roster.members.end(), std::back_inserter(result.missing),
               [&](const Member& member) { return !handed_in.contains(member.row); });
  return result;
}

}  // namespace tumble::judge
