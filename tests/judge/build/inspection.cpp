#include "judge/build/inspection.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

namespace tumble::judge {

namespace fs = std::filesystem;

std::vector<fs::path> dependencies_of(const fs::path& rule) {
  std::ifstream in(rule);
  std::vector<fs::path> files;
  std::string word;
  bool after_target = false;
  const auto finish = [&] {
    if (after_target && !word.empty()) files.push_back(fs::path(word).lexically_normal());
    if (word.ends_with(':')) after_target = true;
    word.clear();
  };
  for (char c; in.get(c);) {
    if (c == '\\' && (in.peek() == '\n' || in.peek() == ' ' || in.peek() == '#'))
      in.peek() == '\n' ? finish() : void(word += static_cast<char>(in.get()));
    else if (c == ' ' || c == '\n')
      finish();
    else
      word += c;
  }
  finish();
  return files;
}

AllowedHeaders::AllowedHeaders(const fs::path& precompiled_rule,
                               const std::vector<fs::path>& contracts)
    : files_(contracts.begin(), contracts.end()) {
  for (const fs::path& file : dependencies_of(precompiled_rule)) {
    files_.insert(file);
    const bool of_eigen = file.string().find("/Eigen/") != std::string::npos;
    if (!of_eigen) folders_.insert(file.parent_path());
    if (file.filename() == "cmath") standard_library_ = file.parent_path();
  }
}

bool AllowedHeaders::contains(const fs::path& header) const {
  if (files_.contains(header) || folders_.contains(header.parent_path())) return true;
  const auto [end, rest] = std::mismatch(standard_library_.begin(), standard_library_.end(),
                                         header.begin(), header.end());
  static_cast<void>(rest);
  return !standard_library_.empty() && end == standard_library_.end();
}

namespace {

/// Both compilers put this line before what the source wrote in assembler.
constexpr const char* inline_assembler = "#APP";
/// Directives that read files, or build other directives from pieces.
constexpr std::array<const char*, 7> directives = {".incbin", ".include", ".macro", ".altmacro",
                                                   ".irp",    ".rept",    ".rep"};

/// The line without what stands between double quotes.
std::string outside_quotes(const std::string& line) {
  std::string outside;
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (quoted && line[i] == '\\') ++i;
    if (!quoted) outside += line[i];
  }
  return outside;
}

bool is_suspicious(const std::string& line) {
  if (line.find(inline_assembler) != std::string::npos) return true;
  if (line.find('.') == std::string::npos) return false;
  const std::string code = outside_quotes(line);
  return std::any_of(directives.begin(), directives.end(), [&](const char* directive) {
    return code.find(directive) != std::string::npos;
  });
}

}  // namespace

std::size_t line_with_assembler(const fs::path& assembly) {
  std::ifstream in(assembly);
  std::size_t number = 1;
  for (std::string line; std::getline(in, line); ++number)
    if (is_suspicious(line)) return number;
  return 0;
}

}  // namespace tumble::judge
