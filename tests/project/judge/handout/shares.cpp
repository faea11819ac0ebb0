/// @file
/// How much of each solution can be read in one file that is handed out. The library is left out of
/// the rule: it holds the same mathematics under other names, and the guide says so. Its share is
/// printed beside: ctest -V -R project/judge/handout/shares
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <map>

#include "project/judge/handout/token_runs.hpp"
#include "project/judge/handout/whole_tree.hpp"

using namespace tumble::test;

namespace {

/// No file but the library's may hold more of a solution.
constexpr double bound = 0.35;

std::set<TokenRun> set_of(const std::vector<TokenRun>& runs) { return {runs.begin(), runs.end()}; }

/// The runs that a student has to write: those of the solution that are not in its stub.
std::vector<TokenRun> written_runs(const fs::path& solution) {
  std::vector<TokenRun> runs = runs_of(text_of(root() / "solutions" / solution));
  const std::set<TokenRun> given = set_of(runs_of(text_of(root() / "exercises" / solution)));
  std::erase_if(runs, [&](const TokenRun& run) { return given.contains(run); });
  return runs;
}

struct Largest {
  double share = 0;
  std::string file;
};

struct Shares {
  std::string unit;
  Largest elsewhere, in_library;
};

std::vector<Shares> shares_in(const HandedOut& handed_out) {
  std::map<std::string, std::set<TokenRun>> others;
  for (const fs::path& file : handed_out.files({".cpp", ".hpp", ".md"}))
    others[file.string()] = set_of(runs_of(text_of(handed_out.tree() / file)));
  std::vector<Shares> all;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root() / "solutions")) {
    if (entry.path().extension() != ".cpp") continue;
    const fs::path unit = entry.path().lexically_relative(root() / "solutions");
    const std::vector<TokenRun> runs = written_runs(unit);
    Shares shares{(unit.parent_path() / unit.stem()).string(), {}, {}};
    for (const auto& [file, there] : others) {
      Largest& largest = file.starts_with("lib/include/") ? shares.in_library : shares.elsewhere;
      const double share = share_in(runs, there);
      if (share > largest.share) largest = {share, file};
    }
    all.push_back(shares);
  }
  std::sort(all.begin(), all.end(),
            [](const Shares& a, const Shares& b) { return a.elsewhere.share > b.elsewhere.share; });
  return all;
}

void print(const std::vector<Shares>& all) {
  std::printf("%-45s %5s  %-60s %5s  %s\n", "solution", "%", "in", "%", "in the library");
  for (const Shares& each : all)
    std::printf("%-45s %5.1f  %-60s %5.1f  %s\n", each.unit.c_str(), 100 * each.elsewhere.share,
                each.elsewhere.file.c_str(), 100 * each.in_library.share,
                each.in_library.file.c_str());
}

}  // namespace

TEST_CASE("runs: comments and types do not count, names and signs do") {
  CHECK(tokens_of("  # define X\nconst double x = 2.5e3; // y\n/* z */ std::sin(x)") ==
        std::vector<std::string>{"x", "=", "2.5e3", ";", "sin", "(", "x", ")"});
  CHECK(runs_of("a b c d e").empty());
  const std::string text = "a = b + c * d;";
  CHECK(runs_of(text).size() == 3);
  CHECK(share_in(runs_of(text), set_of(runs_of(text))) == 1);
  CHECK(share_in(runs_of(text), set_of(runs_of("a = b + c * e;"))) == doctest::Approx(1.0 / 3));
}

TEST_CASE("hand-out: no file beside the library contains a solution") {
  if (!can_hand_out()) return;
  const std::vector<Shares> all = shares_in(HandedOut(all_chapters()));
  CHECK(all.size() >= 54);
  print(all);
  for (const Shares& each : all)
    CHECK_MESSAGE(each.elsewhere.share <= bound, each.unit << " in " << each.elsewhere.file);
}
