#include "judge/course/code_hash.hpp"

#include <algorithm>

#include "judge/course/stable_hash.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

namespace fs = std::filesystem;

namespace {

template <class Iterator>
std::vector<fs::path> sources_in(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const fs::directory_entry& entry : Iterator(folder)) {
    const fs::path extension = entry.path().extension();
    if (entry.is_regular_file() && (extension == ".hpp" || extension == ".cpp"))
      files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<fs::path> code_in(const fs::path& folder) {
  return sources_in<fs::directory_iterator>(folder);
}

std::vector<fs::path> code_below(const fs::path& folder) {
  return sources_in<fs::recursive_directory_iterator>(folder);
}

std::uint64_t code_hash(const std::vector<fs::path>& files, std::uint64_t start) {
  std::uint64_t hash = start;
  for (const fs::path& file : files)
    hash = stable_hash(file.filename().string() + support::read_text(file), hash);
  return hash;
}

}  // namespace tumble::judge
