#include "judge/commands/given_files.hpp"

namespace tumble::judge {

fs::path file_in(const fs::path& folder, const Unit& unit) {
  const std::string name = unit.name + ".cpp";
  const fs::path in_chapter = folder / unit.chapter / name;
  const bool flat =
      !fs::exists(fs::symlink_status(in_chapter)) && fs::exists(fs::symlink_status(folder / name));
  return flat ? folder / name : in_chapter;
}

}  // namespace tumble::judge
