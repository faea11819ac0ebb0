#include "judge/page/page_build.hpp"

#include <nlohmann/json.hpp>

#include "judge/build/diagnostics.hpp"
#include "judge/build/header_errors.hpp"
#include "judge/build/link_failure.hpp"
#include "judge/build/source_code.hpp"
#include "judge/build/source_text.hpp"

namespace tumble::judge {

namespace {

bool contains_assembler(const std::string& source) {
  return mentions(source, "asm") || mentions(source, "__asm") || mentions(source, "__asm__");
}

/// What of Eigen is not there, though it is installed where the judge runs natively, and may not be
/// seen: "fatal error: 'Eigen/Dense' file not found". Empty if nothing.
std::string missing_of_eigen(const std::string& output) {
  const auto end = output.find("' file not found");
  const auto start = output.rfind('\'', end - 1);
  if (end == std::string::npos || start == std::string::npos) return {};
  const std::string header = output.substr(start + 1, end - start - 1);
  return header.starts_with("Eigen/") || header.starts_with("unsupported/") ? header : "";
}

std::string forbidden_header(const PageBuild& build) {
  return build.headers.empty() ? missing_of_eigen(build.output) : build.headers.front();
}

/// Where the page's compiler finds the file.
fs::path place_of(const Unit& unit) { return fs::path("/student") / (unit.name + ".cpp"); }

std::string refusal(const Course& course, const Unit& unit, const std::string& source) {
  std::string why = too_large(source.size());
  if (why.empty()) why = reason_to_refuse(source);
  if (why.empty()) return {};
  return fs::relative(course.exercise(unit), course.root).string() + " " + why;
}

void report_failure(BuildReport& report, const PageBuild& build, const Course& course,
                    const Unit& unit, const std::string& source) {
  report.outcome =
      build.step == "limit" ? BuildOutcome::too_expensive : BuildOutcome::does_not_compile;
  const std::string output = header_errors_at(place_of(unit), source, build.output);
  report.detail = messages_about(place_of(unit), output, true) + advice_on(output);
  if (build.step == "link")
    explain_link_failure(report, course, unit, build.output, build.functions, source);
}

}  // namespace

PageBuild page_build_of(const nlohmann::json& j) {
  return {j.at("ok"), j.at("step"), j.at("output"), j.at("headers"),
          j.value("functions", std::vector<std::string>())};
}

BuildReport report_of(const PageBuild& build, const Course& course, const Unit& unit,
                      const std::string& source) {
  BuildReport report;
  if (report.detail = refusal(course, unit, source); !report.detail.empty())
    report.outcome = BuildOutcome::refused;
  else if (report.detail = forbidden_header(build); !report.detail.empty())
    report.outcome = BuildOutcome::forbidden_include;
  else if (contains_assembler(source))
    report.outcome = BuildOutcome::assembly;
  else if (!build.ok)
    report_failure(report, build, course, unit, source);
  else
    report.warnings = messages_about(place_of(unit), build.output, false);
  return report;
}

}  // namespace tumble::judge
