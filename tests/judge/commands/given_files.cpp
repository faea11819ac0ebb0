#include "judge/commands/given_files.hpp"

#include "judge/class/file_kinds.hpp"
#include "judge/commands/grading_module.hpp"
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
  const fs::path given = fs::weakly_canonical(from, error);
  require(!error, from.string(), " cannot be read: ", error.message());
  require(is_archive(given) || !fs::exists(given, error) || fs::is_directory(given, error),
          from.string(), " is a file: --from takes the folder that holds yours, or a zip");
  if (is_archive(given))
    file_of_ = grading_module(course).unpacked(course, given, from.string());
  else
    file_of_ = [given](const Unit& unit) { return file_in(given, unit); };
}

}  // namespace tumble::judge
