#include "judge/class/collect.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "judge/class/archive.hpp"
#include "judge/class/canonical_names.hpp"
#include "judge/class/file_kinds.hpp"
#include "judge/class/file_names.hpp"
#include "judge/class/gradescope_metadata.hpp"
#include "support/entry.hpp"
#include "support/how_many.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

constexpr const char* metadata_file = "submission_metadata.yml";

std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> entries;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end(),
            [](const fs::path& a, const fs::path& b) { return natural_less(a, b); });
  return entries;
}

std::string file_of(const fs::path& path) { return path.filename().string(); }

bool is_plain_folder(const fs::path& path) { return fs::is_directory(fs::symlink_status(path)); }

/// What a file or folder is that can be no submission, whatever platform it comes from; else empty.
std::string why_nobodys(const fs::path& path) {
  if (is_clutter(file_of(path))) return "an operating system's own";
  if (file_of(path).starts_with(".")) return "hidden";
  if (fs::is_symlink(fs::symlink_status(path))) return "a symbolic link, which is not followed";
  if (!is_plain_folder(path) && !support::is_file(path)) return "neither a file nor a folder";
  return "";
}

/// Does Canvas's download alone look like this? Files that are named its way, and nothing that
/// anybody else would have handed in.
bool is_canvas(const std::vector<fs::path>& entries) {
  bool any = false;
  for (const fs::path& entry : entries) {
    const bool named = support::is_file(entry) && canvas_entry(file_of(entry)).has_value();
    const bool other = is_plain_folder(entry) || !archive_stem(file_of(entry)).empty() ||
                       !source_stem(file_of(entry)).empty();
    if (!named && other && why_nobodys(entry).empty()) return false;
    any = any || named;
  }
  return any;
}

Lms recognised(const fs::path& folder) {
  if (support::is_file(folder / metadata_file)) return Lms::gradescope;
  const std::vector<fs::path> entries = entries_of(folder);
  const auto moodles = [](const fs::path& entry) {
    return moodle_entry(file_of(entry)).has_value();
  };
  if (std::any_of(entries.begin(), entries.end(), moodles)) return Lms::moodle;
  return is_canvas(entries) ? Lms::canvas : Lms::none;
}

/// Does a folder hold one student's work, not a class's?
bool is_one_students(const Course& course, const std::vector<fs::path>& entries) {
  return std::any_of(entries.begin(), entries.end(), [&](const fs::path& entry) {
    return is_plain_folder(entry) &&
           (file_of(entry) == "exercises" ||
            std::any_of(course.units.begin(), course.units.end(),
                        [&](const Unit& unit) { return unit.chapter == file_of(entry); }));
  });
}

/// The folder in which the submissions lie: a platform's export, and a zip of a folder, have one
/// that holds all.
fs::path innermost(const Course& course, const fs::path& folder, bool was_zip) {
  if (recognised(folder) != Lms::none) return folder;
  std::vector<fs::path> entries = entries_of(folder);
  std::erase_if(entries, [](const fs::path& entry) { return !why_nobodys(entry).empty(); });
  if (entries.size() != 1 || !is_plain_folder(entries.front())) return folder;
  const bool certain = recognised(entries.front()) != Lms::none;
  const std::vector<fs::path> within = entries_of(entries.front());
  const auto work = std::count_if(within.begin(), within.end(), [](const fs::path& entry) {
    return is_plain_folder(entry) || !archive_stem(file_of(entry)).empty();
  });
  const bool students = was_zip && !is_one_students(course, within) && work > 1;
  return certain || students ? entries.front() : folder;
}

/// Collects from one folder.
class SubmissionCollector {
 public:
  SubmissionCollector(ClassWork& work, const fs::path& folder, Lms lms)
      : work_(work), folder_(folder), lms_(lms) {}

  void collect() {
    if (lms_ == Lms::gradescope) read_metadata();
    for (const fs::path& entry : entries_of(folder_)) {
      if (const std::string why = why_nobodys(entry); !why.empty())
        leave_out(entry, why);
      else
        add(entry);
    }
    add_missing();
    for (auto& [key, submission] : named_) work_.submissions.push_back(std::move(submission));
  }

 private:
  void leave_out(const fs::path& entry, const std::string& why) {
    work_.left_out.push_back({entry.string(), why});
  }

  void add(const fs::path& entry) {
    const std::string name = file_of(entry);
    if (lms_ == Lms::moodle)
      if (const auto says = moodle_entry(name)) return add_moodle(*says, entry);
    if (lms_ == Lms::canvas && support::is_file(entry))
      if (const auto says = canvas_entry(name)) return add_canvas(*says, entry);
    if (lms_ == Lms::gradescope && name == metadata_file) return;
    if (metadata_.contains(name)) return add_gradescope(name, entry);
    add_plain(entry);
  }

  /// A folder or an archive for each student.
  void add_plain(const fs::path& entry) {
    const std::string name = file_of(entry);
    const std::string stem = archive_stem(name), foreign = foreign_archive_stem(name);
    if (is_plain_folder(entry)) {
      add_whole(name, entry);
    } else if (!stem.empty()) {
      add_whole(stem, entry).is_archive = true;
    } else if (!foreign.empty()) {
      add_whole(foreign, entry).refused =
          "is " + name + ", an archive that cannot be read here: ask for a .zip";
    } else if (lms_ == Lms::none && canvas_entry(name)) {
      leave_out(entry, "neither a folder nor an archive; if Canvas has named it: --from canvas");
    } else {
      leave_out(entry, "neither a folder nor an archive");
    }
  }

  Submission& add_whole(const std::string& student, const fs::path& path) {
    Submission submission{canonical(student), path};  // one record, wherever it was packed
    submission.answer_under = student + "/";
    work_.submissions.push_back(std::move(submission));
    return work_.submissions.back();
  }

  /// The submission that a platform's number stands for.
  Submission& of(const LmsEntry& says) {
    Submission& submission = named_[canonical(says.key())];
    submission.student = canonical(says.key());
    submission.path = folder_;
    submission.who = {canonical(says.name), says.id, ""};
    return submission;
  }

  static void add_part(Submission& submission, const std::string& file, const fs::path& path) {
    if (!foreign_archive_stem(file).empty())
      submission.notes.push_back(file + " in it is an archive that cannot be read here");
    std::string name = file;  // Canvas may have two of one name
    const auto taken = [&](const Part& part) { return part.name == name; };
    for (int n = 1; std::any_of(submission.parts.begin(), submission.parts.end(), taken); ++n)
      name = std::to_string(n) + "/" + file;
    submission.parts.push_back({name, path});
  }

  void add_moodle(const LmsEntry& says, const fs::path& entry) {
    Submission& submission = of(says);
    if (!says.kind.empty())
      submission.notes.push_back(
          "Moodle's \"" + says.kind +
          "\" are there. We grade files of exercises in them; we do not grade texts.");
    else if (says.is_text)
      submission.notes.emplace_back("a text was typed into Moodle: it is not graded");
    submission.answer_under = says.key() + "_assignsubmission_file_/";
    const std::string typed = says.kind.empty() ? "typed text" : says.kind;
    add_part(submission, says.is_text ? typed : says.file, entry);
  }

  void add_canvas(const LmsEntry& says, const fs::path& entry) {
    Submission& submission = of(says);
    submission.marked_late = submission.marked_late || says.late;
    if (says.is_text)
      submission.notes.emplace_back("a text was typed into Canvas: it is not graded");
    if (submission.answer_under.empty() && !says.attachment.empty())
      submission.answer_under = says.name + (says.late ? "_LATE_" : "_") + says.id + "_" +
                                says.attachment + "_";  // Canvas asks for a file that it knows
    add_part(submission, says.file, entry);
  }

  void read_metadata() {
    const fs::path file = folder_ / metadata_file;
    if (!support::is_file(file)) return;
    try {
      metadata_ = read_gradescope_metadata(support::read_text(file));
    } catch (const std::invalid_argument& error) {
      leave_out(file, std::string("cannot be read, so students keep the names of their "
                                  "folders: ") +
                          error.what());
    }
  }

  /// A row for each who has handed in together.
  void add_gradescope(const std::string& name, const fs::path& entry) {
    const GradescopeSubmission& says = metadata_.at(name);
    seen_.insert(name);
    if (says.submitters.empty()) return add_plain(entry);
    for (const Identity& who : says.submitters) {
      const std::string key = !who.email.empty() ? who.email : !who.id.empty() ? who.id : who.name;
      Submission& submission = add_whole(key.empty() ? name : key, entry);
      submission.is_archive = support::is_file(entry);
      submission.who = who;
      submission.handed_in = says.created_at;
      submission.answer_under = name + "/";
      if (says.submitters.size() < 2) continue;
      submission.together = name;
      submission.notes.push_back("handed in by " + std::to_string(says.submitters.size()) +
                                 " together");
    }
  }

  /// Who has handed in by the metadata, and is not there.
  void add_missing() {
    for (const auto& [name, says] : metadata_) {
      if (seen_.contains(name)) continue;
      const std::size_t before = work_.submissions.size();
      add_gradescope(name, folder_ / name);
      for (std::size_t i = before; i < work_.submissions.size(); ++i)
        work_.submissions[i].incomplete =
            name + " is named in submission_metadata.yml, but is not there";
    }
  }

  ClassWork& work_;
  const fs::path& folder_;
  Lms lms_;
  std::map<std::string, Submission> named_;
  std::map<std::string, GradescopeSubmission> metadata_;
  std::set<std::string> seen_;
};

/// A folder that was given, or what a zip that was given is unpacked to.
fs::path unpacked_folder(const fs::path& given, const WorkFolder& work, std::size_t number,
                         std::vector<EntryLeftOut>& left_out) {
  const bool is_archive = fs::is_regular_file(given) && !archive_stem(file_of(given)).empty();
  require(fs::is_directory(given) || is_archive, escaped(given.string()), " is not a folder");
  if (!is_archive) return given;
  fs::path to = work.path() / std::to_string(number) / archive_stem(file_of(given));
  fs::create_directories(to);
  left_out = unpack_class(given, to);
  return to;
}

/// The path below a part of a submission; empty if it is not there.
std::string path_in(const Part& part, const std::string& path) {
  const std::string whole = part.path.string();
  if (path == whole) return part.path.filename().string();
  return path.starts_with(whole + "/") ? path.substr(whole.size() + 1) : "";
}

/// Says in whose submission these are missing. Work that we do not have is no zero: who has handed
/// it in is not judged.
/// @return whether it is anybody's
bool noted_at(const EntryLeftOut& entry, const fs::path& unpacked, std::size_t first,
              ClassWork& all) {
  const std::string path = (unpacked / entry.path).string();
  bool is_anybodys = false;
  for (std::size_t i = first; i < all.submissions.size(); ++i)
    for (const Part& part : parts_of(all.submissions[i]))
      if (const std::string name = path_in(part, path); !name.empty()) {
        const std::string text = name + " in the download " + entry.why;
        is_anybodys = true;
        if (!entry.is_work)
          all.submissions[i].notes.push_back(text);
        else if (all.submissions[i].incomplete.empty())
          all.submissions[i].incomplete = text;
      }
  return is_anybodys;
}

/// Why the first entries of a folder are no submissions: "; product.cpp is …".
std::string some_reasons(const ClassWork& all, std::size_t first) {
  constexpr std::size_t most = 3;
  std::string text;
  const std::size_t end = all.left_out.size();
  for (std::size_t i = first; i < std::min(end, first + most); ++i)
    text += "\n  " + escaped(file_of(all.left_out[i].what)) + ": " + all.left_out[i].why;
  const auto is_canvas_name = [](const LeftOut& each) {
    return canvas_entry(file_of(each.what)).has_value();
  };
  const auto canvas =
      std::find_if(all.left_out.begin() + static_cast<std::ptrdiff_t>(std::min(end, first + most)),
                   all.left_out.end(), is_canvas_name);
  if (canvas != all.left_out.end())  // the reason that helps may come late
    text += "\n  " + escaped(file_of(canvas->what)) + ": " + canvas->why;
  if (end > first + most) text += "\n  … " + std::to_string(end - first) + " entries in all";
  return text;
}

/// Most of what nobody's row has is work that Canvas has named? Then one name among them that is
/// not Canvas's has hidden what this folder is, and most of the class would be missing.
/// @param first     of those that are left out
/// @param submitted how many have a row
void require_no_hidden_download(const ClassWork& all, std::size_t first, std::size_t submitted,
                                const fs::path& given) {
  std::size_t canvas = 0, others = 0;
  std::string strange;
  for (std::size_t i = first; i < all.left_out.size(); ++i) {
    const fs::path what = all.left_out[i].what;
    const std::string name = file_of(what);
    if (source_stem(name).empty() || !why_nobodys(what).empty()) continue;
    const bool named = canvas_entry(name).has_value();
    ++(named ? canvas : others);
    if (!named && strange.empty()) strange = name;
  }
  require(strange.empty() || canvas <= std::max(others, submitted), escaped(given.string()),
          " looks like a download of Canvas: ", support::how_many(canvas, "file"),
          " in it would be nobody's work, because Canvas would not have written the name ",
          escaped(strange), ". If it is one: --from canvas. If it is not: --from folders",
          some_reasons(all, first));
}

void collect_one(const Course& course, const fs::path& given, const std::optional<Lms>& from,
                 const WorkFolder& work, std::size_t number, ClassWork& all) {
  std::vector<EntryLeftOut> not_unpacked;
  const fs::path unpacked = unpacked_folder(given, work, number, not_unpacked);
  const fs::path folder = innermost(course, unpacked, unpacked != given);
  require(!is_one_students(course, entries_of(folder)), escaped(given.string()),
          " looks like one student's work: give the folder that holds the students' folders");
  const Lms lms = from.value_or(recognised(folder));
  const std::size_t before = all.submissions.size(), left_before = all.left_out.size();
  SubmissionCollector(all, folder, lms).collect();
  if (lms == Lms::none && !from)
    require_no_hidden_download(all, left_before, all.submissions.size() - before, given);
  for (std::size_t i = left_before; i < all.left_out.size(); ++i)  // no path of the work folder
    if (all.left_out[i].what.starts_with(unpacked.string() + "/"))
      all.left_out[i].what =
          (given / all.left_out[i].what.substr(unpacked.string().size() + 1)).string();
  for (const EntryLeftOut& entry : not_unpacked)
    if (!noted_at(entry, unpacked, before, all))
      all.left_out.push_back({(given / entry.path).string(), entry.why});
  require(all.submissions.size() > before, escaped(given.string()),
          " holds no submissions: neither folders nor archives", some_reasons(all, left_before));
  if (lms != Lms::none) all.lms = lms;
}

/// Where two paths look the same and are not.
std::string why_alike(const fs::path& a, const fs::path& b) {
  if (a == b || canonical(a.string()) != canonical(b.string())) return "";
  return " (an accent in them is written in two ways)";
}

/// Where a student has several: the last one, or all of them, numbered.
void sort_out(std::vector<Submission>& all, Several several) {
  std::stable_sort(all.begin(), all.end(),
                   [](const Submission& a, const Submission& b) { return a.student < b.student; });
  std::vector<Submission> kept;
  for (std::size_t i = 0; i < all.size();) {
    std::size_t end = i + 1;
    while (end < all.size() && all[end].student == all[i].student) ++end;
    const std::string count = std::to_string(end - i);
    const Submission& next = all[i + 1 < all.size() ? i + 1 : i];
    require(end == i + 1 || several != Several::refused, "two submissions have the name ",
            escaped(all[i].student), ": ", escaped(all[i].path.string()), " and ",
            escaped(next.path.string()), why_alike(all[i].path, next.path),
            R"(; "several" in course.json says which counts)");
    for (std::size_t k = several == Several::last ? end - 1 : i; k < end; ++k) {
      if (end > i + 1) all[k].attempt = several == Several::best ? k - i + 1 : 0;
      if (end > i + 1 && several == Several::last)
        all[k].notes.push_back("the last of " + count + " submissions");
      kept.push_back(std::move(all[k]));
    }
    i = end;
  }
  all = std::move(kept);
}

}  // namespace

ClassWork collect(const Course& course, const std::vector<fs::path>& given,
                  const std::optional<Lms>& from, Several several, const WorkFolder& work) {
  ClassWork all;
  for (std::size_t i = 0; i < given.size(); ++i) collect_one(course, given[i], from, work, i, all);
  sort_out(all.submissions, several);
  return all;
}

}  // namespace tumble::judge
