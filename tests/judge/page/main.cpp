/// @file
/// What the page calls: a request and a verdict, both as JSON.
#include <emscripten.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "judge/commands/matrix.hpp"
#include "judge/course/contract.hpp"
#include "judge/course/hints.hpp"
#include "judge/page/page_build.hpp"
#include "judge/page/page_course.hpp"
#include "judge/page/page_figure.hpp"
#include "judge/page/page_worker.hpp"
#include "judge/verdict/json.hpp"
#include "judge/verdict/judge_answers.hpp"
#include "support/text_file.hpp"

namespace tumble::judge {

Course page_course() {
  Course course;
  course.root = "/course";
  course.units = page_units;
  return course;
}

namespace {

using nlohmann::json, nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

const Unit& unit_with(const Course& course, const std::string& id) {
  const auto found = std::find_if(course.units.begin(), course.units.end(),
                                  [&](const Unit& unit) { return unit.id() == id; });
  if (found == course.units.end()) throw std::invalid_argument("this module has no unit " + id);
  return *found;
}

UnitResult judged(const Course& course, const Unit& unit, const json& request) {
  const std::string source = request.at("source");
  const PageBuild build = page_build_of(request.at("built"));
  UnitResult result =
      result_of_build(unit, course.exercise(unit), report_of(build, course, unit, source));
  const Trial trial{request.at("seed"), request.value("seeds", 1),
                    request.value("onlyCase", std::size_t{0})};
  result.seed = trial.seed;
  if (result.build != BuildOutcome::built) return result;
  PageWorker worker;
  judge_answers(result, trial, worker);
  name_from_source(result, source);
  name_wrong_numbers(result, answer_type(course, unit));
  return result;
}

/// The same where the judge fails: that is nobody's wrong answer.
UnitResult judged_or_failed(const Course& course, const Unit& unit, const json& request) {
  try {
    return judged(course, unit, request);
  } catch (const std::exception& why) {
    UnitResult result = result_of_build(unit, course.exercise(unit), {});
    result.seed = request.at("seed");
    result.judge_failure = why.what();
    return result;
  }
}

/// The verdict names the student's file as it is named in the course.
ordered_json verdict_on(const json& request) {
  const auto start = Clock::now();
  const Course course = page_course();
  const Unit& unit = unit_with(course, request.at("unit"));
  support::write_text_and_folders(course.exercise(unit), request.at("source"));
  UnitResult result = judged_or_failed(course, unit, request);
  const std::chrono::duration<double> here = Clock::now() - start;
  result.seconds = here.count() + request.at("built").value("seconds", 0.);
  return json_of(record_of(course, result));
}

ordered_json description_of(const Course& course, const Unit& unit) {
  const Declaration declaration = read_declaration(course, unit);
  return {{"id", unit.id()},
          {"number", unit.number},
          {"chapter", unit.chapter},
          {"name", unit.name},
          {"title", declaration.title},
          {"signature", declaration.signature},
          {"stub", stub_of(course, unit, Help::buttons)},
          {"hints", read_hints(course, unit)}};
}

/// The text stays until the next call.
const char* kept(std::string text) {
  static std::string last;
  last = std::move(text);
  return last.c_str();
}

template <class Work>
const char* answer_to_page(Work&& work) noexcept {
  try {
    return kept(text_of(work()));
  } catch (const std::exception& why) {
    return kept(text_of(ordered_json{{"failure", why.what()}}));
  }
}

}  // namespace

}  // namespace tumble::judge

extern "C" {
/// The verdict on {"unit", "source", "built", "seed", "seeds"?, "onlyCase"?}, or {"failure": why}.
EMSCRIPTEN_KEEPALIVE const char* judge_unit(const char* request) {
  using namespace tumble::judge;
  return answer_to_page([&] { return verdict_on(json::parse(request)); });
}
/// The units of this module, as units.json lists them.
EMSCRIPTEN_KEEPALIVE const char* describe_units() {
  using namespace tumble::judge;
  return answer_to_page([] {
    const Course course = page_course();
    ordered_json list = ordered_json::array();
    for (const Unit& unit : course.units) list.push_back(description_of(course, unit));
    return list;
  });
}
/// What a reader's functions answer to a figure: page_figure.hpp.
EMSCRIPTEN_KEEPALIVE const char* answer_figure(const char* question) {
  using namespace tumble::judge;
  return answer_to_page([&] { return answer_for_figure(json::parse(question)); });
}
/// The kill matrix of this module: {"matrix": Markdown, "complete": whether all are killed and
/// named}.
EMSCRIPTEN_KEEPALIVE const char* kill_matrix(double seed) {
  using namespace tumble::judge;
  return answer_to_page([&] {
    const Course course = page_course();
    std::ostringstream table;
    const bool complete =
        print_kill_matrix(table, course, course.units, static_cast<std::uint64_t>(seed));
    return ordered_json{{"matrix", table.str()}, {"complete", complete}};
  });
}
}
