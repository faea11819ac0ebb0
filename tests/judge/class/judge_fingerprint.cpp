#include "judge/class/judge_fingerprint.hpp"

#include <algorithm>

#include "judge/course/stable_hash.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

namespace {

bool is_code(const fs::path& file) {
  return file.extension() == ".hpp" || file.extension() == ".cpp";
}

/// The code files of a folder that `wanted` takes, in the order of their names.
template <class Iterator, class Wanted>
std::vector<fs::path> code_in(const fs::path& folder, Wanted wanted) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const fs::directory_entry& entry : Iterator(folder))
    if (entry.is_regular_file() && is_code(entry.path()) && wanted(entry.path()))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::uint64_t hash_of(const std::vector<fs::path>& files, std::uint64_t start) {
  std::uint64_t hash = start;
  for (const fs::path& file : files)
    hash = stable_hash(file.filename().string() + support::read_text(file), hash);
  return hash;
}

std::uint64_t hash_of(const Toolchain& tools) {
  std::uint64_t hash = stable_hash(tools.compiler_id);
  for (const std::string& flag : tools.flags)  // paths may differ from one checkout to the next
    if (flag.find('/') == std::string::npos) hash = stable_hash(flag, hash);
  return hash;
}

}  // namespace

JudgeFingerprint::JudgeFingerprint(const Course& course)
    : course_(course), shared_(hash_of(course.toolchain)) {
  const auto all = [](const fs::path&) { return true; };
  for (const char* folder : {"tests/judge", "lib/include", "lib/support", "lib/objects"})
    shared_ =
        hash_of(code_in<fs::recursive_directory_iterator>(course.root / folder, all), shared_);
}

std::uint64_t JudgeFingerprint::of(const Unit& unit) const {
  const fs::path tests = course_.root / "tests" / unit.chapter;
  const auto is_part = [&](const fs::path& file) {
    return file.extension() == ".hpp" || file.stem() == unit.name;
  };
  std::vector<fs::path> files = code_in<fs::directory_iterator>(tests, is_part);
  files.push_back(course_.contract(unit));
  return hash_of(files, shared_);
}

}  // namespace tumble::judge
