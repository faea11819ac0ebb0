#pragma once
/// @file
/// What the judge owes to everybody, whatever was handed in.

#include <doctest/doctest.h>

#include "judging.hpp"

namespace tumble::test {

namespace detail {

/// The lines of a file that say more than braces and names, and that are not shown by right: no
/// text between quotes, which may be a law or a hint.
inline std::vector<std::string> telling_lines(const fs::path& file) {
  std::vector<std::string> lines;
  for (const std::string& line : lines_of(text_of(file)))
    if (const std::string words = trimmed(line);
        words.size() > 30 && words.find('"') == std::string::npos)
      lines.push_back(words);
  return lines;
}

/// Text that nobody may get to see through the judge.
inline std::vector<std::string> secrets() {
  std::vector<std::string> all = lines_of(text_of("/etc/passwd"));
  for (const char* file :
       {"solutions/04_quaternions/product.cpp", "tests/04_quaternions/product.cpp",
        "tests/04_quaternions/reference.hpp"})
    for (const std::string& line : telling_lines(root() / file)) all.push_back(line);
  return all;
}

/// Secrets in `output` that were not in the submission already.
inline std::vector<std::string> leaks(const std::string& output, const std::string& submission) {
  static const std::vector<std::string> all = secrets();
  std::vector<std::string> found;
  for (const std::string& secret : all)
    if (output.find(secret) != std::string::npos && submission.find(secret) == std::string::npos)
      found.push_back(secret);
  return found;
}

/// Would a terminal take some of this for a command? C1 control characters too: in UTF-8 they are
/// C2 80 to C2 9F.
inline bool commands_the_terminal(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    if ((byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7f) return true;
    if (byte == 0xc2 && next >= 0x80 && next < 0xa0) return true;
  }
  return false;
}

/// Would a continuous-integration runner take a line for a command? GitHub's looks for "::" at the
/// start of a line, after spaces.
inline bool commands_the_runner(const std::string& text) {
  for (const std::string& line : lines_of(text))
    if (trimmed(line).starts_with("::") || trimmed(line).starts_with("##[")) return true;
  return false;
}

/// Lines that look like the judge's own good news. What a submission prints is indented deeper.
inline std::size_t ticks(const std::string& output) {
  std::size_t count = 0;
  for (const std::string& line : lines_of(output)) {
    const auto start = line.find_first_not_of(' ');
    if (start != std::string::npos && start <= 2 && line.substr(start).starts_with("✓")) ++count;
  }
  return count;
}

}  // namespace detail

namespace detail {

inline std::string in_lines(const std::vector<std::string>& all) {
  std::string lines;
  for (const std::string& each : all) lines += each + "\n";
  return lines;
}

}  // namespace detail

/// @param passed whether 4.1 is meant to pass
inline void check_the_judge_stood(const Judgement& judgement, const std::string& submission,
                                  bool passed, std::size_t laws) {
  CHECK(judgement.seconds < most_seconds);
  CHECK(detail::in_lines(judgement.left_behind) == "");
  CHECK(judgement.printed < 100000);
  CHECK(judgement.json_text.size() < 100000);
  CHECK(detail::in_lines(detail::leaks(judgement.output + judgement.json_text, submission)) == "");
  CHECK_FALSE(detail::commands_the_terminal(judgement.output));
  CHECK_FALSE(detail::commands_the_runner(judgement.output));
  // One for 4.2; one for 4.1 if it passes, or else one for each law of it that holds.
  CHECK(detail::ticks(judgement.output) == (passed ? 2 : 1 + laws));
  CHECK(summary_of(judgement.inverse) == "passed");
}

inline void check_verdict(const Judgement& judgement, const std::vector<std::string>& verdicts,
                          std::size_t laws) {
  const std::string summary = summary_of(judgement.product);
  CAPTURE(summary);
  CHECK(std::count(verdicts.begin(), verdicts.end(), summary) == 1);
  if (!judgement.product.is_object()) return;
  CHECK(judgement.product.at("passed") == (summary == "passed"));
  CHECK(judgement.product.at("laws_that_hold") == laws);
}

}  // namespace tumble::test
