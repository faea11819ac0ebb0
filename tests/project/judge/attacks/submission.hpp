#pragma once
/// @file
/// A hostile or broken submission, as tests/project/attacks/ keeps it: a source file whose first
/// comments say what it tries and what the judge has to say to it.

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "tumble/core/require.hpp"

namespace tumble::test {

namespace fs = std::filesystem;

inline fs::path variable(const char* name) {
  const char* value = std::getenv(name);
  require(value != nullptr, "the environment lacks ", name, ": run this with ctest");
  return value;
}

/// The tree that is attacked.
inline fs::path root() { return variable("TUMBLE_ROOT"); }

/// The first `most` bytes of a file: what an attack makes the judge write may be endless.
inline std::string text_of(const fs::path& file, std::size_t most = 16 << 20) {
  std::ifstream in(file, std::ios::binary);
  std::string text;
  std::array<char, 4096> part;
  do {
    in.read(part.data(), static_cast<std::streamsize>(part.size()));
    text.append(part.data(), static_cast<std::size_t>(in.gcount()));
  } while (in && text.size() < most);
  return text;
}

inline std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

struct Submission {
  std::string name;
  std::string text;
  std::vector<std::string> verdicts;  ///< any of them will do
  std::size_t laws = 0;               ///< that hold all the same
};

namespace detail {

inline std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? ""
                                    : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// "forbidden | crashed" → {"forbidden", "crashed"}
/// "wrong | crashed": a bar within a word, as in |L|, divides nothing.
inline std::vector<std::string> alternatives(const std::string& text) {
  const std::string bar = " | ";
  std::vector<std::string> words;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(bar, start), text.size());
    words.push_back(trimmed(text.substr(start, end - start)));
    start = end + bar.size();
  }
  return words;
}

}  // namespace detail

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// @throws std::invalid_argument if the file does not say what it is
inline Submission read_submission(const fs::path& file) {
  // An attack names the tree by @ROOT@: where it stands is known when the test runs.
  std::string text = replaced(text_of(file), "@ROOT@", root().string());
  // What several attacks need, such as reading and writing frames by hand: @forge@ is
  // parts/forge.hpp.
  for (const fs::directory_entry& part :
       fs::directory_iterator(root() / "tests/project/attacks/parts"))
    text = replaced(text, "@" + part.path().stem().string() + "@", text_of(part.path()));
  Submission submission{file.stem().string(), text, {}, 0};
  bool says_what_it_tries = false;
  for (const std::string& line : lines_of(submission.text)) {
    if (!line.starts_with("//")) break;
    const auto value_of = [&](const std::string& key) {
      return line.starts_with(key) ? detail::trimmed(line.substr(key.size())) : std::string();
    };
    says_what_it_tries = says_what_it_tries || !value_of("// Attack:").empty();
    if (const std::string verdict = value_of("// Verdict:"); !verdict.empty())
      submission.verdicts = detail::alternatives(verdict);
    if (const std::string laws = value_of("// Laws:"); !laws.empty())
      submission.laws = static_cast<std::size_t>(std::stoul(laws));
  }
  require(says_what_it_tries, file.string(), " does not say what it tries: // Attack: …");
  require(!submission.verdicts.empty(), file.string(), " expects no verdict: // Verdict: …");
  return submission;
}

/// All submissions of a folder, by name.
inline std::vector<Submission> submissions_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".cpp") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<Submission> submissions;
  for (const fs::path& file : files) submissions.push_back(read_submission(file));
  return submissions;
}

}  // namespace tumble::test
