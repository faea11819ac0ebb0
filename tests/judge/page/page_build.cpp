#include "judge/page/page_build.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "judge/build/diagnostics.hpp"
#include "judge/build/link_failure.hpp"
#include "judge/build/source_text.hpp"
#include "judge/verdict/names_from_source.hpp"

namespace tumble::judge {

namespace {

bool contains_assembler(const std::string& source) {
  return mentions(source, "asm") || mentions(source, "__asm") || mentions(source, "__asm__");
}

/// Of Eigen an exercise has Eigen/Core. All else that it may not see is not there at all.
bool is_forbidden(const std::string& header) {
  const auto at = header.find("Eigen/");
  if (at == std::string::npos) return false;
  const std::string path = header.substr(at);
  return header.find("unsupported/") != std::string::npos ||
         !(path == "Eigen/Core" || path.starts_with("Eigen/src/Core/") ||
           path.starts_with("Eigen/src/plugins/"));
}

/// The headers that were looked for and are not there: "… 'Eigen/Dense' file not found".
std::vector<std::string> missing_headers(const std::string& output) {
  std::vector<std::string> headers;
  for (auto end = output.find("' file not found"); end != std::string::npos;
       end = output.find("' file not found", end + 1))
    if (const auto start = output.rfind('\'', end - 1); start != std::string::npos)
      headers.push_back(output.substr(start + 1, end - start - 1));
  return headers;
}

std::string forbidden_header(const PageBuild& build) {
  for (const auto& headers : {build.headers, missing_headers(build.output)})
    if (const auto found = std::find_if(headers.begin(), headers.end(), is_forbidden);
        found != headers.end())
      return *found;
  return {};
}

std::string refusal(const Course& course, const Unit& unit, const std::string& source) {
  std::string why = too_large(source.size());
  if (why.empty()) why = reason_to_refuse(source);
  if (why.empty()) return {};
  return fs::relative(course.exercise(unit), course.root).string() + " " + why;
}

void report_failure(BuildReport& report, const PageBuild& build, const Course& course,
                    const Unit& unit) {
  report.outcome =
      build.step == "time" ? BuildOutcome::too_expensive : BuildOutcome::does_not_compile;
  report.detail = messages_about(unit.name + ".cpp", build.output, true);
  if (build.step == "link")
    explain_link_failure(report, course, unit, build.output, build.functions);
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
    report_failure(report, build, course, unit);
  else
    report.warnings = messages_about(unit.name + ".cpp", build.output, false);
  return report;
}

}  // namespace tumble::judge
