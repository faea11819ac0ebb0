#include "judge/verdict/crash_place.hpp"

#include <regex>

#include "judge/build/worker_build.hpp"
#include "judge/conversation/student_worker.hpp"

namespace tumble::judge {

namespace {

/// What the sanitizer calls it: "runtime error: division by zero", "stack-overflow", …
std::string name_in(const std::string& report) {
  if (report.find("Assertion `") != std::string::npos) return {};  // says more than what followed
  std::smatch found;
  if (std::regex_search(report, found, std::regex("runtime error: ([^\n]*)"))) return found[1];
  if (std::regex_search(report, found, std::regex("AddressSanitizer: ([a-zA-Z-]+)")))
    return found[1];
  return {};
}

/// The first line of `file` that the report mentions.
std::string line_in(const std::string& report, const std::string& file) {
  std::smatch found;
  const std::regex place(file + ":([0-9]+)");
  return std::regex_search(report, found, place) ? found[1].str() : std::string();
}

/// clang's runtime leaves the addresses of a report to a program that may not be there: resolve
/// them with the binutils, which a compiler needs anyway.
std::string resolve_addresses(const std::string& report, const WorkerProgram& worker) {
  std::vector<std::string> command{"/usr/bin/addr2line", "-e", worker.file.string()};
  const std::regex frame("#[0-9]+ 0x([0-9a-f]+)");
  for (std::sregex_iterator it(report.begin(), report.end(), frame), end; it != end; ++it)
    command.push_back((*it)[1]);
  if (command.size() == 3 || !std::filesystem::exists(command[0])) return {};
  Confinement confinement = worker.confinement;
  confinement.limits.memory_bytes = 1ull << 30;
  return run_confined(command, {}, confinement).output;
}

}  // namespace

std::string crash_place(const Course& course, const SpecRun& run, const Unit& unit,
                        const std::filesystem::path& source, const std::filesystem::path& folder) {
  const WorkerBuild build = build_worker(course, unit, source, folder, Instrumentation::sanitizers);
  if (build.outcome != BuildOutcome::built) return {};
  StudentWorker worker(build.worker);
  const std::vector<CaseResult> again = run_spec(run, worker);
  if (again.empty() || again.front().passed()) return {};
  const std::string& report = again.front().finding->printed;
  const std::string file = source.filename().string();
  std::string line = line_in(report, file);
  if (line.empty()) line = line_in(resolve_addresses(report, build.worker), file);
  if (line.empty()) return {};
  const std::string name = name_in(report);
  return file + ":" + line + (name.empty() ? "" : ": " + name);
}

}  // namespace tumble::judge
