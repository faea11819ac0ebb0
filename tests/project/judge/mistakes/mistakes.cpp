// Every mistake in tests/project/mistakes/ is caught with every seed, and gets no name that is not
// right.
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <set>
#include <thread>

#include "mistake.hpp"
#include "project/judge/attacks/judging.hpp"

using namespace tumble::test;

namespace {

/// Right numbers from memory that is gone: `check` says so to the student.
constexpr const char* by_luck = "passed by luck";

/// The judge's verdict on one unit; null if it gave none.
nlohmann::json try_to_judge(const Mistake& mistake, unsigned seed) {
  const Place place;
  const fs::path file = place.files() / (mistake.unit + ".cpp");
  const fs::path json = place.path() / "results.json";
  fs::create_directory(file.parent_path());
  std::ofstream(file, std::ios::binary) << mistake.text;
  // --strict leaves out the second run with sanitizers, which finds places, not names, and luck.
  const std::string command = "cd " + place.path().string() +
                              " && TMPDIR=" + place.temporary().string() + " timeout -k 1 120 '" +
                              variable("TUMBLE_JUDGE").string() + "' check " + mistake.unit +
                              (mistake.expects(by_luck) ? " --from " : " --strict --from ") +
                              place.files().string() + " --json " + json.string() + " --seed " +
                              std::to_string(seed) + " > /dev/null 2>&1 < /dev/null";
  static_cast<void>(std::system(command.c_str()));
  const auto results = nlohmann::json::parse(text_of(json), nullptr, false);
  if (!results.is_object() || results.value("units", nlohmann::json()).size() != 1) return {};
  return results["units"][0];
}

/// On a busy machine the judge may say that it failed: then it is asked again.
nlohmann::json verdict_on(const Mistake& mistake, unsigned seed) {
  nlohmann::json verdict = try_to_judge(mistake, seed);
  for (int again = 0; again < 3 && summary_of(verdict) == "judge failed"; ++again)
    verdict = try_to_judge(mistake, seed);
  return verdict;
}

/// All verdicts with one seed, several at once.
std::vector<nlohmann::json> verdicts_on(const std::vector<Mistake>& mistakes, unsigned seed) {
  std::vector<nlohmann::json> verdicts(mistakes.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i; (i = next++) < mistakes.size();)
      verdicts[i] = verdict_on(mistakes[i], seed);
  };
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
    threads.emplace_back(work);
  for (std::thread& thread : threads) thread.join();
  return verdicts;
}

std::set<std::string> names_in(const nlohmann::json& verdict) {
  std::set<std::string> names;
  for (const nlohmann::json& each : verdict.at("cases"))
    for (const nlohmann::json& name : each.value("misconceptions", nlohmann::json::array()))
      names.insert(name.get<std::string>());
  return names;
}

void check(const Mistake& mistake, const nlohmann::json& verdict) {
  const std::string path = mistake.path();
  CAPTURE(path);
  REQUIRE(verdict.is_object());
  const std::string explanation = verdict.at("explanation");
  CAPTURE(explanation);
  const bool is_luck = explanation.find("right by luck") != std::string::npos;
  const std::string outcome = is_luck ? by_luck : verdict.at("summary").get<std::string>();
  CAPTURE(outcome);
  CHECK(mistake.expects(outcome));
  const std::set<std::string> names = names_in(verdict);
  for (const std::string& name : names) {
    CAPTURE(name);
    CHECK(mistake.allows(name));
  }
  for (const std::string& name : mistake.names) {
    CAPTURE(name);
    CHECK(names.contains(name));
  }
}

/// How many seeds: 1, or as many as TUMBLE_SEEDS says.
unsigned seed_count() {
  const char* wanted = std::getenv("TUMBLE_SEEDS");
  return wanted ? static_cast<unsigned>(std::stoul(wanted)) : 1;
}

/// Those that TUMBLE_MISTAKES names: "04_quaternions" for those with that in their paths, "/" for
/// all. If it is not set, each fourth, which is what a run of all tests has time for.
std::vector<Mistake> chosen() {
  std::vector<Mistake> mistakes = all_mistakes();
  if (const char* part = std::getenv("TUMBLE_MISTAKES")) {
    std::erase_if(mistakes,
                  [&](const Mistake& each) { return each.path().find(part) == std::string::npos; });
    return mistakes;
  }
  std::size_t number = 0;
  std::erase_if(mistakes, [&](const Mistake&) { return number++ % 4 != 0; });
  return mistakes;
}

}  // namespace

TEST_CASE("mistakes: two at least for each exercise, 150 at least in all") {
  std::map<std::string, int> counts;
  const std::vector<Mistake> mistakes = all_mistakes();
  for (const Mistake& mistake : mistakes) ++counts[mistake.unit];
  std::size_t exercises = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root() / "solutions")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string unit =
        fs::relative(entry.path(), root() / "solutions").replace_extension().string();
    CAPTURE(unit);
    CHECK(counts[unit] >= 2);
    ++exercises;
  }
  CHECK(counts.size() == exercises);  // none for an exercise that is not there
  CHECK(mistakes.size() >= 150);
}

TEST_CASE("mistakes: a replacement that does not fit the solution is refused, with its line") {
  const Place place;
  const fs::path file = place.path() / "04_quaternions/product.mistakes";
  fs::create_directory(file.parent_path());
  const auto refusal_of = [&](const std::string& text) {
    std::ofstream(file) << text;
    try {
      MistakesReader(file).read();
    } catch (const std::invalid_argument& why) {
      return std::string(why.what());
    }
    return std::string();
  };
  const std::string head = "# a\nexpect: wrong\nWhat is wrong.\n";
  CHECK(refusal_of(head + "-#include \"contract.hpp\"\n+\n") == "");
  const auto says = [&](const std::string& text, const char* what) {
    CHECK_MESSAGE(refusal_of(text).find(what) != std::string::npos, text);
  };
  says(head + "-there is no such line\n+x\n", ":6: these lines do not stand in the solution");
  says(head + "-\n+x\n", "stand in the solution more than once");
  says(head + "+x\n", ":4: no line of the solution is replaced");
  says("# a\nWhat is wrong.\n", ":2: here should stand what to expect");
  says("# a\nexpect: named b\nWhat is wrong.\n-x\n", "no outcome is expected");
  says("stray\n", ":1: here should stand \"# name\"");
}

TEST_CASE("mistakes: each is caught with every seed, and no name is wrong") {
  const std::vector<Mistake> mistakes = chosen();
  for (unsigned seed = 1; seed <= seed_count(); ++seed) {
    CAPTURE(seed);
    const std::vector<nlohmann::json> verdicts = verdicts_on(mistakes, seed);
    for (std::size_t i = 0; i < mistakes.size(); ++i) check(mistakes[i], verdicts[i]);
  }
}
