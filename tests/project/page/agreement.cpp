/// @file
/// The same file, the same seed, the same verdict: in a browser and natively, but for what differs
/// by nature (tests/judge/page/README.md).
#include <doctest/doctest.h>

#include <map>
#include <regex>

#include "project/judge/mistakes/mistake.hpp"
#include "project/page/page_judge.hpp"

using namespace tumble::test;
using Json = nlohmann::ordered_json;

namespace {

/// A file, and how far its two verdicts may be apart.
struct Compared {
  Written file;
  bool may_differ = false;  ///< in what they say, by nature
  bool may_pass = false;    ///< with one compiler, and fail with another
};

/// The solution and the stub of every unit in the page.
std::vector<Compared> answers_of_the_course() {
  std::vector<Compared> files;
  for (const Json& unit : Json::parse(tumble::support::read_text(
           std::filesystem::path(from_environment("TUMBLE_EXERCISES")) / "units.json"))) {
    const std::string id = unit.at("id");
    files.push_back({{id, "stub", unit.at("stub")}});
    files.push_back({{id, "solution", text_of(root() / "solutions" / (id + ".cpp"))}});
  }
  return files;
}

/// A verdict without what is never the same twice: its times.
Json without_times(Json verdict) {
  verdict.erase("seconds");
  const std::string text = verdict.at("explanation");
  verdict["explanation"] = std::regex_replace(text, std::regex(R"(  \([0-9.]+ s\))"), "");
  return verdict;
}

/// And without what another compiler says in other words, of a file that it refuses or warns about.
Json without_words_of_compiler(Json verdict) {
  verdict.erase("detail");
  std::string& text = verdict.at("explanation").get_ref<std::string&>();
  if (verdict.at("summary") == "does not compile") text.clear();
  if (const auto warned = text.find("  The compiler warns:"); warned != std::string::npos)
    text.erase(warned);
  return verdict;
}

/// And without what another standard library says in its assertions and exceptions.
Json without_words_of_library(Json verdict) {
  for (Json& each : verdict.at("cases"))
    if (each.value("outcome", "") == "crashed" || each.value("outcome", "") == "threw")
      each.erase("detail");
  std::string& text = verdict.at("explanation").get_ref<std::string&>();
  static const std::regex words("(an assertion failed|Your code threw an exception)[,:] .*");
  text = std::regex_replace(text, words, "$1");
  return verdict;
}

/// Says what differs; nothing if nothing does.
std::string difference(const Json& page, const Json& native) {
  std::string text;
  for (const auto& [key, value] : native.items())
    if (!page.contains(key) || page.at(key) != value)
      text += key + "\n  native: " + value.dump() +
              "\n  page:   " + (page.contains(key) ? page.at(key).dump() : "nothing") + "\n";
  for (const auto& [key, value] : page.items())
    if (!native.contains(key)) text += key + " in the page only: " + value.dump() + "\n";
  return text;
}

/// Mistakes whose verdicts are not the same to the letter, and why that is so.
const std::map<std::string, std::string> differs_by_nature{
    {"03_rotation_matrices/euler_angles_to_matrix turn_kept",
     "the order of calls in one expression is the compiler's"},
    {"07_bounding_boxes/fit_oriented_box last_point_only", "axes that only rounding chooses"},
    {"11_when_bodies_meet/collide_with_friction slow_slip_is_none",
     "the last digit of sin() among 17"},
    {"11_when_bodies_meet/bounce never_rests", "memory is used up before the time is"},
    {"11_when_bodies_meet/overlapping_pairs asked_in_the_order_of_the_sweep",
     "std::sort orders what is equal as it likes"},
    {"11_when_bodies_meet/overlapping_pairs order_of_the_sweep",
     "std::sort orders what is equal as it likes"},
    {"11_when_bodies_meet/overlapping_pairs sorted_by_the_first_only",
     "std::sort orders what is equal as it likes"},
    {"11_when_bodies_meet/overlapping_pairs whole_numbers",
     "std::sort orders what is equal as it likes"}};

/// A variable that was never set has the mark of its compiler, and so has a NaN; memory that is
/// gone holds what its compiler has left there, and the answer may even be right. A loop that
/// nothing ends is stopped by the limit of time, of memory or of calls: by which one first, the
/// machine decides.
Compared compared(const Mistake& mistake) {
  const bool reads_what_is_gone =
      mistake.expects("passed by luck") || mistake.name.starts_with("auto_");
  const bool meets_one_of_several_limits = mistake.expects("hung") && mistake.outcomes.size() > 1;
  return {.file = {mistake.unit, mistake.name, mistake.text},
          .may_differ = reads_what_is_gone || meets_one_of_several_limits ||
                        mistake.allows("never set") || mistake.allows("not a number") ||
                        mistake.allows("a rounded constant") ||
                        differs_by_nature.contains(mistake.unit + " " + mistake.name),
          .may_pass = reads_what_is_gone};
}

/// Mistakes that students make: every so many of the page's chapters, as many as are asked for.
std::vector<Compared> mistakes_of_students(std::size_t most) {
  const std::set<std::string> chapters = chapters_in_page();
  std::vector<Compared> all, files;
  for (const Mistake& each : all_mistakes())
    if (chapters.contains(each.unit.substr(0, 2))) all.push_back(compared(each));
  const std::size_t step = std::max<std::size_t>(1, all.size() / most);
  for (std::size_t i = 0; i < all.size(); i += step) files.push_back(all[i]);
  return files;
}

/// The verdicts of both judges, compared.
void compare(PageJudge& page, const Compared& each) {
  const Written& file = each.file;
  CAPTURE(file.unit);
  CAPTURE(file.name);
  const Json outcome = page.verdict_on(file, usual_seed);
  REQUIRE_MESSAGE(!outcome.contains("failure"), outcome.dump());
  if (each.may_pass) return;
  const Json native = native_verdict_on(file, usual_seed);
  CHECK(outcome.at("passed") == native.at("passed"));
  if (each.may_differ) return;
  const auto normal = [](const Json& verdict) {
    return without_words_of_library(without_words_of_compiler(without_times(verdict)));
  };
  const std::string differs = difference(normal(outcome), normal(native));
  CHECK_MESSAGE(differs.empty(), file.unit, " ", file.name, ":\n", differs);
}

}  // namespace

TEST_CASE("stubs, solutions and mistakes have the same verdict in a browser as natively") {
  if (!can_judge_in_page()) return;
  PageJudge page;
  std::vector<Compared> files = answers_of_the_course();
  REQUIRE(files.size() >= 2);
  const std::string most = from_environment("TUMBLE_PAGE_MISTAKES");
  for (Compared& each : mistakes_of_students(most.empty() ? 100 : std::stoul(most)))
    files.push_back(std::move(each));
  for (const Compared& each : files) compare(page, each);
  MESSAGE(files.size(), " files compared");
}
