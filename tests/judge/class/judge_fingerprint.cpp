#include "judge/class/judge_fingerprint.hpp"

#include "judge/course/code_hash.hpp"
#include "judge/course/stable_hash.hpp"

namespace tumble::judge {

namespace {

std::uint64_t hash_of(const Toolchain& tools) {
  std::uint64_t hash = stable_hash(tools.compiler_id);
  for (const auto* flags : {&tools.flags, &tools.sanitizer_flags})
    for (const std::string& flag : *flags)  // paths may differ from one checkout to the next
      if (flag.find('/') == std::string::npos) hash = stable_hash(flag, hash);
  return hash;
}

}  // namespace

JudgeFingerprint::JudgeFingerprint(const Course& course)
    : course_(course), shared_(hash_of(course.toolchain)) {
  for (const char* folder : {"tests/judge", "lib/include", "lib/support", "lib/objects"})
    shared_ = code_hash(code_below(course.root / folder), shared_);
}

std::uint64_t JudgeFingerprint::of(const Unit& unit) const {
  std::vector<fs::path> files = code_in(course_.root / "tests" / unit.chapter);
  std::erase_if(files, [&](const fs::path& file) {
    return file.extension() == ".cpp" && file.stem() != unit.name;
  });
  files.push_back(course_.contract(unit));
  return code_hash(files, shared_);
}

}  // namespace tumble::judge
