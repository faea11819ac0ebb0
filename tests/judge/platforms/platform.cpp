#include "judge/platforms/platform.hpp"

#include <unistd.h>

#include <nlohmann/json.hpp>

#include "judge/course/text_file.hpp"
#include "judge/platforms/results.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

/// What a platform says about a submission, as it stands: enough to tell submissions apart.
std::string said_about_it(const fs::path& file) {
  return fs::is_regular_file(file) ? read_text(file) : "";
}

PlatformRun on_gradescope(const fs::path& root, const CourseSettings& settings) {
  return {root / "submission", root / "results" / "results.json",
          said_about_it(root / "submission_metadata.json"),
          [settings](const StudentRecord& record, const std::string&) {
            return gradescope_results(settings, record);
          }};
}

PlatformRun on_prairielearn(const fs::path& root, const CourseSettings& settings) {
  return {root / "student", root / "results" / "results.json",
          said_about_it(root / "data" / "data.json"),
          [settings](const StudentRecord& record, const std::string& figure) {
            return prairielearn_results(settings, record, figure);
          }};
}

std::map<std::string, std::string> environment() {
  std::map<std::string, std::string> all;
  for (char** each = environ; *each != nullptr; ++each) {
    const std::string text = *each;
    const std::size_t at = text.find('=');
    if (at != std::string::npos) all[text.substr(0, at)] = text.substr(at + 1);
  }
  return all;
}

PlatformRun on_classroom50(const fs::path& root, const CourseSettings& settings) {
  const auto variables = environment();
  const auto commit = variables.find("COMMIT_URL");
  return {root, root / "result.json", commit == variables.end() ? "" : commit->second,
          [settings, variables](const StudentRecord& record, const std::string&) {
            return classroom50_result(settings, record, variables);
          },
          root / "engine.svg"};
}

}  // namespace

PlatformRun platform_run(const std::string& platform, const fs::path& root,
                         const CourseSettings& settings) {
  using Reader = PlatformRun (*)(const fs::path&, const CourseSettings&);
  const std::map<std::string, Reader> readers = {{"gradescope", on_gradescope},
                                                 {"prairielearn", on_prairielearn},
                                                 {"classroom50", on_classroom50}};
  const auto reader = readers.find(platform);
  require(reader != readers.end(), "there is no platform '", platform,
          "'; there are: gradescope, prairielearn, classroom50");
  PlatformRun run = reader->second(root, settings);
  require(fs::is_directory(run.submission), "there is no submission in ", run.submission.string());
  return run;
}

}  // namespace tumble::judge
