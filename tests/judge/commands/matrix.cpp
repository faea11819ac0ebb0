#include "judge/commands/matrix.hpp"

#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>

#include "judge/spec/impostor.hpp"
#include "judge/spec/load_spec.hpp"
#include "judge/spec/misconception.hpp"
#include "judge/spec/run.hpp"

namespace tumble::judge {

namespace {

/// What the spec made of one misconception.
struct Kill {
  std::size_t failed = 0, cases = 0;
  std::string named;       ///< what the first case that failed has named: what a student is told
  bool explained = false;  ///< by a section of the page

  std::string verdict(const std::string& name) const {
    if (failed == 0) return "**survives**";
    if (named.empty()) return "**not named**";
    if (named == "not a number" || named == "infinite") return "yes, as “" + named + "”";
    if (named != name) return "**as " + named + "**";
    return explained ? "yes" : "**no such section in the page**";
  }
};

/// Whether the chapter's page has this heading, or is not written yet.
bool is_explained(const fs::path& page, const std::string& section) {
  std::ifstream in(page);
  if (!in) return true;
  for (std::string line; std::getline(in, line);)
    if (line.starts_with('#') && line.ends_with("# " + section)) return true;
  return false;
}

Kill try_to_kill(const Unit& unit, std::size_t k, std::uint64_t seed) {
  Impostor impostor(k);
  Kill kill;
  for (const CaseResult& result : run_spec({unit.id(), seed}, impostor)) {
    ++kill.cases;
    if (result.passed()) continue;
    if (++kill.failed > 1) continue;
    for (const Misconception& misconception : result.finding->misconceptions)
      kill.named += (kill.named.empty() ? "" : " or ") + misconception.name;
  }
  return kill;
}

/// A text in a cell of a Markdown table.
std::string table_cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

}  // namespace

bool print_kill_matrix(std::ostream& out, const Course& course, const std::vector<Unit>& units,
                       std::uint64_t seed) {
  constexpr std::size_t at_least = 4;
  bool complete = true;
  std::size_t total = 0, right = 0;
  out << "| unit | misconception | cases that fail | named |\n|---|---|---|---|\n";
  for (const Unit& unit : units) {
    load_spec(unit);
    const std::string id = unit.id();
    const std::vector<Misconception>& misconceptions = misconceptions_of(id);
    for (std::size_t k = 0; k < misconceptions.size(); ++k) {
      Kill kill = try_to_kill(unit, k, seed);
      kill.explained = is_explained(course.page(unit), misconceptions[k].section);
      const std::string verdict = kill.verdict(misconceptions[k].name);
      out << "| " << unit.number << " " << unit.name << " | " << table_cell(misconceptions[k].name)
          << " | " << kill.failed << " of " << kill.cases << " | " << verdict << " |\n";
      ++total;
      right += verdict.starts_with("yes") ? 1u : 0u;
    }
    if (misconceptions.size() < at_least) {
      out << "| " << unit.number << " " << unit.name << " | **only " << misconceptions.size()
          << " misconceptions** | | |\n";
      complete = false;
    }
  }
  out << "\n"
      << units.size() << " units, " << total << " misconceptions, " << right
      << " of them killed and named.\n";
  return complete && right == total;
}

}  // namespace tumble::judge
