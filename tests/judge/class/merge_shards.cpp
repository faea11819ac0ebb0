#include "judge/class/merge_shards.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "judge/class/one_student_each.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

/// "shard 3/10 (in grades-3)"
std::string called(const FoundShard& found) {
  return "shard " + name_of(found.manifest.shard) + " (in " + escaped(found.folder.path.string()) +
         ")";
}

std::vector<FoundShard> all_shards_in(const std::vector<fs::path>& folders) {
  std::vector<FoundShard> all;
  for (const fs::path& folder : folders) {
    require(fs::is_directory(folder), escaped(folder.string()), " is not a folder");
    std::vector<FoundShard> found = shards_in({folder});
    require(!found.empty(), escaped(folder.string()),
            " holds no shard: ./tumble grade … --shard 1/3 --out DIR makes one");
    std::move(found.begin(), found.end(), std::back_inserter(all));
  }
  std::stable_sort(all.begin(), all.end(), [](const FoundShard& a, const FoundShard& b) {
    return a.manifest.shard.number < b.manifest.shard.number;
  });
  return all;
}

std::set<std::string> students_of(const ClassRoll& roll) {
  std::set<std::string> students;
  for (const Submission& each : roll.submissions) students.insert(each.student);
  return students;
}

/// A student whom one class has and another has not; empty if there is none.
std::string only_in(const ClassRoll& one, const ClassRoll& other) {
  const std::set<std::string> others = students_of(other);
  for (const Submission& each : one.submissions)
    if (!others.contains(each.student)) return each.student;
  return "";
}

std::string difference(const FoundShard& a, const FoundShard& b) {
  const std::pair<const FoundShard*, const FoundShard*> orders[] = {{&a, &b}, {&b, &a}};
  for (const auto& [one, other] : orders)
    if (const std::string student = only_in(one->manifest.roll, other->manifest.roll);
        !student.empty())
      return escaped(student) + " is in the class of " + called(*one) + " and not in that of " +
             called(*other);
  return "the rosters, names or several submissions of " + called(a) + " and " + called(b) +
         " differ";
}

std::optional<std::string> bytes_of(const fs::path& file) {
  if (!fs::exists(file)) return std::nullopt;
  return support::read_text(file);
}

void copy_if_new(const fs::path& from, const fs::path& to) {
  const std::optional<std::string> bytes = bytes_of(from);
  if (bytes && bytes != bytes_of(to)) support::write_text_and_folders(to, *bytes);
}

CourseSettings settings_of(const Course& course, const FoundShard& found) {
  if (!found.manifest.settings) return default_settings(course);
  return settings_in(course, *found.manifest.settings, "course.json of " + called(found));
}

}  // namespace

ShardedClass::ShardedClass(const Course& course, const std::vector<fs::path>& folders)
    : found_(all_shards_in(folders)) {
  require_all_there();
  require_same_class();
  settings_ = settings_of(course, first());
  settings_.rules = with_names_of_rows(settings_.rules, everybody(roll()));
  require_this_course(course);
  require_sound_records();
}

void ShardedClass::require_all_there() const {
  std::set<std::size_t> numbers;
  for (const FoundShard& each : found_) {
    require(each.manifest.shard.of == count(), called(first()), " and ", called(each),
            " divide the class into different numbers of shards: give --merge the folders of one "
            "division");
    numbers.insert(each.manifest.shard.number);
  }
  std::string missing;
  std::size_t how_many = 0;
  for (std::size_t i = 1; i <= count(); ++i)
    if (!numbers.contains(i) && ++how_many <= 20)
      missing += (missing.empty() ? "" : ", ") + name_of({i, count()});
  if (how_many > 20) missing += " and " + std::to_string(how_many - 20) + " more";
  require(missing.empty(), how_many == 1 ? "a shard is" : "shards are", " missing: ", missing,
          ". Judge what is missing with --shard, or name its folder here");
}

void ShardedClass::require_same_class() const {
  const nlohmann::ordered_json roll_of_first = json_of(roll());
  for (const FoundShard& each : found_) {
    const ShardManifest &one = first().manifest, &other = each.manifest;
    require(
        one.settings == other.settings, "course.json is not the same in ", called(first()),
        " and in ", called(each),
        ": judge one of them again with the other's course.json; verdicts that still hold stay");
    require(one.seed == other.seed, called(first()), " and ", called(each),
            " have different inputs: put a \"seed\" into course.json, and judge both again");
    require(one.judges == other.judges, called(first()), " and ", called(each),
            " come from different judges: another version of tumble, or another compiler. Judge "
            "one of them again, with the other's tumble and compiler");
    require(roll_of_first == json_of(other.roll), difference(first(), each),
            ": give all shards the same submissions and the same roster");
  }
}

void ShardedClass::require_this_course(const Course& course) const {
  const auto counts_here = [&](const std::string& id) {
    return std::any_of(settings_.units.begin(), settings_.units.end(),
                       [&](const Unit& unit) { return unit.id() == id; });
  };
  for (const auto& [id, judge] : judges())
    require(counts_here(id), called(first()), " is about another course: ", id,
            ", which this one (", course.root.string(), ") does not have");
  for (const Unit& unit : settings_.units)
    require(judges().contains(unit.id()), called(first()), " is about another course: it lacks ",
            unit.id(), ", which counts here");
}

const GradesFolder& ShardedClass::folder_of(const std::string& student) const {
  const std::size_t number = shard_number(student, count());
  return std::find_if(found_.begin(), found_.end(),
                      [&](const FoundShard& each) { return each.manifest.shard.number == number; })
      ->folder;
}

/// What speaks against a record that can be read; empty if nothing.
std::string ShardedClass::wrong_with(const StudentRecord& record,
                                     const Submission& submission) const {
  if (record.student != submission.student)
    return "is about " + escaped(record.student) + ", not about " + escaped(submission.student);
  if (record.seed != seed_of(first().manifest.seed, submission.student))
    return "was judged with other inputs than its shard";
  for (const UnitRecord& unit : record.units) {
    const auto judge = judges().find(unit.unit);
    if (unit.seed != record.seed)
      return "has a verdict on " + unit.number + " with other inputs than its shard's";
    if (judge == judges().end() || judge->second != unit.judge)
      return "has a verdict on " + unit.number + " of another judge than its shard's";
  }
  return "";
}

/// Where else the student has a record, and another one.
std::string ShardedClass::another_record(const Submission& submission) const {
  const GradesFolder& folder = folder_of(submission.student);
  const fs::path own = folder.record_of(submission);
  const std::optional<std::string> bytes = bytes_of(own);
  for (const FoundShard& each : found_) {
    if (each.folder.path == folder.path) continue;
    const fs::path other = each.folder.record_of(submission);
    const std::optional<std::string> others = bytes_of(other);
    if (others && others != bytes)
      return escaped(submission.student) + " has two records, " + escaped(own.string()) + " and " +
             escaped(other.string()) + ", that differ; a student is in one shard, this one in " +
             name_of({shard_number(submission.student, count()), count()}) +
             ": move aside the record that does not count";
  }
  return "";
}

std::string ShardedClass::wrong_with(const Submission& submission) const {
  if (std::string two = another_record(submission); !two.empty()) return two;
  const fs::path file = folder_of(submission.student).record_of(submission);
  const std::string again = ": judge shard " +
                            name_of({shard_number(submission.student, count()), count()}) +
                            " again, which keeps what holds";
  try {
    const std::optional<StudentRecord> record = read_record(file);
    const std::string wrong = record ? wrong_with(*record, submission) : "";
    return wrong.empty() ? "" : escaped(file.string()) + " " + wrong + again;
  } catch (const std::runtime_error& error) {
    return escaped(error.what()) + again;
  }
}

void ShardedClass::require_sound_records() const {
  constexpr std::size_t most = 20;
  std::string all;
  std::size_t count = 0;
  for (const Submission& submission : roll().submissions)
    if (const std::string wrong = wrong_with(submission); !wrong.empty() && ++count <= most)
      all += "\n  " + wrong;
  if (count > most) all += "\n  and " + std::to_string(count - most) + " more";
  require(all.empty(), "nothing is merged, because of these records:", all);
}

void ShardedClass::bring_to(const GradesFolder& out) const {
  for (const Submission& submission : roll().submissions) {
    const GradesFolder& from = folder_of(submission.student);
    if (fs::equivalent(from.path, out.path)) continue;
    copy_if_new(from.record_of(submission), out.record_of(submission));
    const std::string name = file_name_for(submission.student);
    copy_sources(from.sources(submission.attempt) / name, out.sources(submission.attempt) / name,
                 settings_.units);
  }
  if (!settings_.seed)
    support::write_text(out.seed(), std::to_string(first().manifest.seed) + "\n");
}

}  // namespace tumble::judge
