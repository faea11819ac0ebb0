#pragma once
/// @file
/// The judge in a browser and the judge of this build, asked about the same files.

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "project/harness/chromium.hpp"
#include "project/harness/command.hpp"
#include "project/harness/served_folder.hpp"
#include "project/harness/skip.hpp"
#include "project/harness/temporary_folder.hpp"
#include "support/text_file.hpp"

namespace tumble::test {

/// Of the inputs of every question here.
constexpr std::uint64_t usual_seed = 20250711;

/// A student's file.
struct Written {
  std::string unit;  ///< "04_quaternions/product"
  std::string name;  ///< of what is tried, "solution"
  std::string text;
};

/// What a variable of the environment says; empty if there is none.
inline std::string from_environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// The chapters that the page was built with: "04", …
inline std::set<std::string> chapters_in_page() {
  std::set<std::string> digits;
  const std::string units = from_environment("TUMBLE_EXERCISES") + "/units.json";
  for (const nlohmann::json& unit : nlohmann::json::parse(support::read_text(units)))
    digits.insert(unit.at("id").get<std::string>().substr(0, 2));
  return digits;
}

/// Whether there is a page's judge to ask, and a browser; says what is missing.
inline bool can_judge_in_page() {
  if (!std::filesystem::exists(from_environment("TUMBLE_EXERCISES") + "/units.json"))
    return skip("the exercises in the page are not built: ./tumble book --exercises"), false;
  if (server_program().empty()) return skip("cpp-httplib is not here"), false;
  if (chromium_program().empty()) return skip("there is no Chromium"), false;
  return true;
}

/// The judge in headless Chromium: the folder that a site serves as exercises/.
class PageJudge {
 public:
  PageJudge() : served_(from_environment("TUMBLE_EXERCISES")) {
    browser_.open(served_.address() + "manifest.json");  // any address of the same server
    browser_.evaluate("import('/client.mjs').then(({Judge}) => { judge = new Judge(); })");
  }

  Chromium& browser() { return browser_; }

  /// The kill matrix of a chapter, "04": {matrix, complete}.
  nlohmann::ordered_json kill_matrix(const std::string& digits, std::uint64_t seed) {
    return browser_.evaluate(
        "Promise.all([import('/judges.mjs'), import('/assets.mjs'), import('/judge/judge_" +
        digits +
        ".mjs')]).then(async ([{ChapterJudge}, {Assets, manifest}, {default: factory}]) => {"
        "const wasm = await new Assets(await manifest()).response('judge/judge_" +
        digits +
        ".wasm');"
        "const judge = await ChapterJudge.start(factory, await WebAssembly.compileStreaming(wasm));"
        "return judge.killMatrix(" +
        std::to_string(seed) + "); })");
  }

  /// The verdict's JSON; {"failure": why} if there is none.
  nlohmann::ordered_json verdict_on(const Written& file, std::uint64_t seed) {
    const nlohmann::json source = file.text;
    const nlohmann::ordered_json said = outcome_of(
        "judge.check('" + file.unit + "', " + source.dump() + ", {seed: " + std::to_string(seed) +
        "}).then((verdict) => ({verdict: verdict.json}))");
    return said.contains("verdict")
               ? nlohmann::ordered_json::parse(said.at("verdict").get<std::string>())
               : said;
  }

  /// What an engine of these files, and of solutions for what they lack, answers to a figure of
  /// chapter 9: {numbers, own} or {outcome, detail}; {"failure": why} if nothing is answered.
  nlohmann::ordered_json answer_to_figure(const std::string& topic,
                                          const nlohmann::ordered_json& numbers,
                                          const std::vector<Written>& files) {
    nlohmann::json own = nlohmann::json::array();
    for (const Written& file : files) own.push_back({{"id", file.unit}, {"text", file.text}});
    return outcome_of("judge.answerFigure('09', '" + topic + "', " + numbers.dump() + ", " +
                      own.dump() + ")");
  }

 private:
  /// What a promise has come to, asked again and again: a first verdict may take a minute here.
  nlohmann::ordered_json outcome_of(const std::string& promise) {
    browser_.evaluate("outcome = null; " + promise +
                      ".then((it) => { outcome = it; }, (why) => { outcome = "
                      "{failure: String(why)}; }); 0");
    const auto began = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - began < std::chrono::minutes(5)) {
      const nlohmann::json text = browser_.evaluate(
          "new Promise((resolve) => setTimeout(resolve, 50)).then(() => JSON.stringify(outcome))");
      if (text != "null") return nlohmann::ordered_json::parse(text.get<std::string>());
    }
    throw std::runtime_error("the page gives no verdict");
  }

  ServedFolder served_;
  Chromium browser_;
};

/// What `./tumble check --json` says of a file. No sanitizers: a page has none.
inline nlohmann::ordered_json native_verdict_on(const Written& file, std::uint64_t seed) {
  const TemporaryFolder folder;
  const std::filesystem::path source = folder.path() / (file.unit + ".cpp");
  std::filesystem::create_directories(source.parent_path());
  support::write_text(source, file.text);
  const std::filesystem::path json = folder.path() / "verdict.json";
  run_command(from_environment("TUMBLE_JUDGE") + " check " + file.unit + " --once --seed " +
              std::to_string(seed) + " --from " + folder.path().string() + " --json " +
              json.string());
  std::string text = support::read_text(json);
  // In a page the file lies where the course has it.
  const std::string here = folder.path().string() + "/";
  for (auto at = text.find(here); at != std::string::npos; at = text.find(here, at))
    text.replace(at, here.size(), "exercises/");
  return nlohmann::ordered_json::parse(text).at("units").at(0);
}

}  // namespace tumble::test
