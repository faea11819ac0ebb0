#include "judge/platforms/platform.hpp"

#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "judge/class/grades.hpp"
#include "judge/platforms/fitted.hpp"
#include "judge/platforms/results.hpp"
#include "support/nearest.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

using Files = std::map<fs::path, std::string>;

std::map<std::string, std::string> environment() {
  std::map<std::string, std::string> all;
  for (char** each = environ; *each != nullptr; ++each) {
    const std::string text = *each;
    const std::size_t at = text.find('=');
    if (at != std::string::npos) all[text.substr(0, at)] = text.substr(at + 1);
  }
  return all;
}

std::string value_or_empty(const std::map<std::string, std::string>& map, const char* key) {
  const auto found = map.find(key);
  return found == map.end() ? "" : found->second;
}

/// The number of the submission and who made it: the same when it is graded again.
std::string gradescope_identity(const fs::path& metadata) {
  require(fs::is_regular_file(metadata), metadata.string(), " is not there: Gradescope writes it");
  const auto j = nlohmann::json::parse(support::read_text(metadata));
  return j.value("id", nlohmann::json()).dump() + j.value("users", nlohmann::json()).dump();
}

PlatformRun on_gradescope(const fs::path& root, const CourseSettings& settings) {
  return {root / "submission", gradescope_identity(root / "submission_metadata.json"),
          [=](const StudentRecord& record, const std::string& figure) {
            return Files{
                {root / "results" / "results.json", gradescope_results(settings, record, figure)}};
          }};
}

/// The question's folder tests/ holds the solutions: images are public.
PlatformRun on_prairielearn(const fs::path& root, const CourseSettings& settings) {
  const fs::path secret = root / "tests", data = root / "data" / "data.json";
  require(fs::is_regular_file(data), data.string(), " is not there: PrairieLearn writes it");
  if (fs::exists(secret)) fs::permissions(secret, fs::perms::owner_all);
  return {root / "student", support::read_text(data),
          [=](const StudentRecord& record, const std::string& figure) {
            return Files{{root / "results" / "results.json",
                          prairielearn_results(settings, record, figure)}};
          },
          secret / "solutions"};
}

PlatformRun on_classroom50(const fs::path& root, const CourseSettings& settings) {
  const auto variables = environment();
  return {root, value_or_empty(variables, "COMMIT_URL"),
          [=](const StudentRecord& record, const std::string& figure) {
            Files files{{root / "result.json", classroom50_result(settings, record, variables)},
                        {root / "release-body.md", markdown_results(settings, record)}};
            if (!figure.empty()) files[root / "engine.svg"] = figure;
            return files;
          }};
}

PlatformRun on_github_actions(const fs::path& root, const CourseSettings& settings) {
  const auto variables = environment();
  const fs::path summary = value_or_empty(variables, "GITHUB_STEP_SUMMARY");
  PlatformRun run{root,
                  value_or_empty(variables, "GITHUB_REPOSITORY") + "@" +
                      value_or_empty(variables, "GITHUB_SHA"),
                  [=](const StudentRecord& record, const std::string& figure) {
                    const StudentRecord shown = without_hidden(settings, fitted(record));
                    Files files{{root / "results" / "junit.xml", grades_junit(settings, {shown})}};
                    if (!summary.empty()) files[summary] = markdown_results(settings, record);
                    if (!figure.empty()) files[root / "results" / "engine.svg"] = figure;
                    return files;
                  }};
  run.status_tells = true;
  return run;
}

}  // namespace

void require_platform(const std::string& name) {
  const std::vector<std::string> names{"gradescope", "prairielearn", "classroom50",
                                       "github-actions"};
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  const std::string meant = support::did_you_mean(name, names);
  require(false, "there is no platform '", name, "'",
          meant.empty() ? std::string("; there are: ") + platforms : meant);
}

PlatformRun platform_run(const std::string& platform, const fs::path& root,
                         const CourseSettings& settings) {
  using Reader = PlatformRun (*)(const fs::path&, const CourseSettings&);
  static const std::map<std::string, Reader> readers = {{"gradescope", on_gradescope},
                                                        {"prairielearn", on_prairielearn},
                                                        {"classroom50", on_classroom50},
                                                        {"github-actions", on_github_actions}};
  require_platform(platform);
  PlatformRun run = readers.at(platform)(fs::weakly_canonical(root), settings);
  require(fs::is_directory(run.submission), "there is no submission in ", run.submission.string());
  return run;
}

}  // namespace tumble::judge
