#include "judge/verdict/crash_place.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "judge/build/worker_build.hpp"
#include "judge/conversation/student_worker.hpp"

namespace tumble::judge {

namespace {

// A program that crashed may have printed anything: the report is searched by hand, because a
// regular expression of the standard library recurses for every character.

/// The characters from `start` on that `belongs` takes, at most `most`.
template <class Predicate>
std::string run_of(const std::string& text, std::size_t start, std::size_t most,
                   Predicate belongs) {
  std::string run;
  for (std::size_t i = start; i < text.size() && run.size() < most && belongs(text[i]); ++i)
    run += text[i];
  return run;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_hexadecimal(char c) { return is_digit(c) || (c >= 'a' && c <= 'f'); }

/// Whether this is a signal's name, which is told already. (Behind the walls, abort() ends by
/// another signal than its own.)
bool is_signal(const std::string& name) {
  constexpr std::array signals = {"SEGV", "ABRT", "BUS", "FPE", "ILL", "TRAP"};
  return std::find(signals.begin(), signals.end(), name) != signals.end();
}

/// What the sanitizer calls it: "division by zero", "stack-overflow", …
std::string name_in(const std::string& report) {
  if (report.find("Assertion `") != std::string::npos) return {};  // says more than what followed
  for (const std::string start : {"runtime error: ", "AddressSanitizer: "}) {
    const auto at = report.find(start);
    const bool one_word = start.front() == 'A';
    if (at == std::string::npos) continue;
    std::string name = run_of(report, at + start.size(), 200,
                              [&](char c) { return c != '\n' && !(one_word && c == ' '); });
    return is_signal(name) ? "" : name;
  }
  return {};
}

/// The first line number of `file` that the report mentions.
std::string line_in(const std::string& report, const std::string& file) {
  for (auto at = report.find(file + ":"); at != std::string::npos;
       at = report.find(file + ":", at + 1))
    if (std::string line = run_of(report, at + file.size() + 1, 7, is_digit); !line.empty())
      return line;
  return {};
}

/// The addresses of the frames "#3 0x4c3b5e …" of a report.
std::vector<std::string> addresses_in(const std::string& report) {
  constexpr std::size_t most = 100;
  std::vector<std::string> addresses;
  for (auto at = report.find(" 0x"); at != std::string::npos && addresses.size() < most;
       at = report.find(" 0x", at + 1))
    if (at > 0 && is_digit(report[at - 1]))
      addresses.push_back(run_of(report, at + 3, 16, is_hexadecimal));
  return addresses;
}

/// clang's runtime leaves the addresses of a report to a program that may not be there: resolve
/// them with the binutils, which a compiler needs anyway.
std::string resolve_addresses(const std::string& report, const WorkerProgram& worker) {
  const std::vector<std::string> addresses = addresses_in(report);
  std::vector<std::string> command{"/usr/bin/addr2line", "-e", worker.file.string()};
  command.insert(command.end(), addresses.begin(), addresses.end());
  if (addresses.empty() || !std::filesystem::exists(command[0])) return {};
  Walls walls = worker.walls;
  walls.limits.memory_bytes = 1ull << 30;
  return run_confined(command, {}, walls).output;
}

}  // namespace

std::string place_in_report(const std::string& report, const std::string& file,
                            const WorkerProgram& worker) {
  std::string line = line_in(report, file);
  if (line.empty()) line = line_in(resolve_addresses(report, worker), file);
  if (line.empty()) return {};
  const std::string name = name_in(report);
  return file + ":" + line + (name.empty() ? "" : ": " + name);
}

CrashPlace crash_place(const Job& job, const SpecRun& run, int cpu_seconds) {
  Job again_with_sanitizers = job;
  again_with_sanitizers.folder /= "sanitized";
  WorkerBuild build;
  try {
    build = build_worker(again_with_sanitizers, Instrumentation::sanitizers);
  } catch (const std::runtime_error& why) {  // the verdict stands without the line
    return {"", why.what()};
  }
  if (build.outcome != BuildOutcome::built) return {};
  build.worker.walls.limits.cpu_seconds = cpu_seconds;
  StudentWorker worker(build.worker);
  const std::vector<CaseResult> again = run_spec(run, worker);
  const auto failed = std::find_if(again.begin(), again.end(),
                                   [](const CaseResult& each) { return !each.passed(); });
  if (failed == again.end()) return {};
  const Finding& finding = *failed->finding;
  // A wrong answer is as wrong with sanitizers: then what was printed is the student's own.
  if (finding.outcome == Outcome::wrong) return {};
  return {place_in_report(finding.printed, job.source.filename().string(), build.worker), ""};
}

}  // namespace tumble::judge
