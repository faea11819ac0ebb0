#include "judge/commands/given_files.hpp"

#include "judge/class/file_kinds.hpp"
#include "support/entry.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

fs::path file_in(const fs::path& folder, const Unit& unit) {
  const std::string name = unit.name + ".cpp";
  const fs::path in_chapter = folder / unit.chapter / name;
  const bool flat = !support::is_there(in_chapter) && support::is_there(folder / name);
  return flat ? folder / name : in_chapter;
}

bool is_archive(const fs::path& given) {
  std::error_code unreadable;  // what is named on the command line may be a link
  return fs::is_regular_file(given, unreadable) && !archive_stem(given.filename().string()).empty();
}

GivenFiles::GivenFiles(const Course& course, const fs::path& from) {
  std::error_code error;
  folder_ = fs::weakly_canonical(from, error);
  require(!error, from.string(), " cannot be read: ", error.message());
  if (!is_archive(folder_)) return;
  Submission submission{"", folder_};
  submission.is_archive = true;
  unpacked_ = std::make_unique<Sources>(course, course.units, submission);
  require(unpacked_->refused().empty(), from.string(), " ", unpacked_->refused());
}

fs::path GivenFiles::of(const Unit& unit) const {
  return unpacked_ ? unpacked_->of(unit) : file_in(folder_, unit);
}

}  // namespace tumble::judge
