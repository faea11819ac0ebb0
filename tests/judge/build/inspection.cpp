#include "judge/build/inspection.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <iterator>
#include <stdexcept>

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
  const std::vector<fs::path> brought = dependencies_of(precompiled_rule);
  if (brought.empty())
    throw std::runtime_error("the course's precompiled header is not built: no " +
                             precompiled_rule.string());
  for (const fs::path& file : brought) {
    files_.insert(file);
    const bool of_eigen = file.string().find("/Eigen/") != std::string::npos;
    if (!of_eigen) folders_.insert(file.parent_path());
    // All of the standard library, and what the compiler brings (with sanitizers, lists of its
    // own).
    if (file.filename() == "cmath") trees_.push_back(file.parent_path());
    if (file.filename() == "stddef.h") trees_.push_back(file.parent_path().parent_path());
  }
}

bool AllowedHeaders::contains(const fs::path& header) const {
  return files_.contains(header) || folders_.contains(header.parent_path()) ||
         std::any_of(trees_.begin(), trees_.end(), [&](const fs::path& tree) {
           return std::mismatch(tree.begin(), tree.end(), header.begin(), header.end()).first ==
                  tree.end();
         });
}

namespace {

/// Both compilers put this line before what the source wrote in assembler.
constexpr const char* inline_assembler = "#APP";
/// Directives that read files, or build other directives from pieces.
constexpr std::array<const char*, 7> directives = {".incbin", ".include", ".macro", ".altmacro",
                                                   ".irp",    ".rept",    ".rep"};

/// A line that only holds the bytes of a text, which may say anything.
bool is_text(const std::string& line) {
  const auto start = line.find_first_not_of(" \t");
  if (start == std::string::npos) return true;
  const auto quote = line.find('"');
  const std::string directive = line.substr(start, quote - start);
  if (directive != ".string\t" && directive != ".ascii\t" && directive != ".asciz\t") return false;
  for (std::size_t i = quote + 1; i < line.size(); ++i) {
    if (line[i] == '\\')
      ++i;
    else if (line[i] == '"')
      return i + 1 == line.size();
  }
  return false;
}

bool is_suspicious(std::string line) {
  if (line.find(inline_assembler) != std::string::npos) return true;
  if (line.find('.') == std::string::npos || is_text(line)) return false;
  std::transform(line.begin(), line.end(), line.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::any_of(directives.begin(), directives.end(), [&](const char* directive) {
    return line.find(directive) != std::string::npos;
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
