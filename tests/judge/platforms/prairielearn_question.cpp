#include "judge/platforms/prairielearn_question.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "judge/course/contract.hpp"
#include "judge/course/stable_hash.hpp"
#include "judge/platforms/time_limits.hpp"
#include "judge/verdict/json.hpp"
#include "judge/verdict/markup.hpp"
#include "support/text_file.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

using nlohmann::ordered_json;

/// The same for the same title, so that a question that is exported again stays the same question.
std::string uuid_of(const std::string& title) {
  const std::uint64_t high = stable_hash(title), low = stable_hash(title, high);
  char text[40];
  std::snprintf(text, sizeof text, "%08x-%04x-4%03x-8%03x-%012llx",
                static_cast<unsigned>(high >> 32), static_cast<unsigned>(high >> 16 & 0xffff),
                static_cast<unsigned>(high & 0xfff), static_cast<unsigned>(low >> 48 & 0xfff),
                static_cast<unsigned long long>(low & 0xffff'ffff'ffffu));
  return text;
}

/// "product.cpp,inverse.cpp"
std::string names_of_files(const CourseSettings& settings) {
  std::map<std::string, std::string> numbers;
  std::string names;
  for (const Unit& unit : settings.units) {
    const auto [same, is_new] = numbers.emplace(unit.name, unit.number);
    require(is_new, "PrairieLearn has no folders: ", same->second, " and ", unit.number, " ",
            unit.name, " cannot be in one question; --each makes a question of each exercise");
    names += (names.empty() ? "" : ",") + unit.name + ".cpp";
  }
  return names;
}

/// Its heading, its declaration, and links to its stub and its contract.
std::string about(const Course& course, const Unit& unit) {
  const Declaration declaration = read_declaration(course, unit);
  return "  <p><strong>" + unit.number + " " + markup(declaration.title) +
         "</strong>: <pl-file-download file-name=\"" + unit.name +
         ".cpp\"></pl-file-download>, <pl-file-download file-name=\"" + unit.chapter +
         "/contract.hpp\"></pl-file-download></p>\n  <pl-code language=\"cpp\">" +
         markup(declaration.signature) + ";</pl-code>\n";
}

/// Half a minute for the start, ten seconds a unit (a function that never ends takes the most, and
/// the grader may have to share its processor), two minutes for the curves.
TimeLimits limits_of(const Course& course, const CourseSettings& settings,
                     const std::optional<int>& wanted) {
  constexpr int most = 600;
  const int work =
      30 + 10 * static_cast<int>(settings.units.size()) + (settings.wants_curve(course) ? 120 : 0);
  return time_limits(std::min(most, work + most_for_what_has_begun), most, wanted);
}

}  // namespace

Words write_question(const Course& course, const CourseSettings& settings, const Grader& grader,
                     const fs::path& question) {
  const TimeLimits limits = limits_of(course, settings, grader.limit);
  Words words{{"FILES", names_of_files(settings)}, {"UNITS", ""}};
  for (const Unit& unit : settings.units) {
    const fs::path files = question / "clientFilesQuestion";
    support::write_text_and_folders(files / (unit.name + ".cpp"), stub_of(course, unit));
    support::write_text_and_folders(files / unit.chapter / "contract.hpp",
                                    support::read_text(course.contract(unit)));
    words["UNITS"] += about(course, unit);
  }
  support::write_text_and_folders(
      question / "info.json",
      text_of(
          {{"uuid", uuid_of(settings.title)},
           {"title", settings.title},
           {"topic", "Rigid-body dynamics"},
           {"type", "v3"},
           {"singleVariant", true},
           {"partialCredit", true},
           {"gradingMethod", "External"},
           {"externalGradingOptions",
            {{"image", grader.image},
             {"entrypoint",
              {"/tumble/tumble", "--no-install", "platform", "prairielearn", "/grade", "--course",
               "/grade/tests/course.json", "--deadline", std::to_string(limits.deadline)}},
             {"timeout", limits.limit},
             {"enableNetworking", false}}}}));
  return words;
}

}  // namespace tumble::judge
