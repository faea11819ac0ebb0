#include "book/tool/known_mistakes.hpp"

#include <map>

namespace tumble::book {

namespace {

/// How many mistakes the list has for each exercise, by its number.
std::map<std::string, int> counts_of(const fs::path& root) {
  const fs::path list = root / "chapters/for_instructors/what_students_get_wrong.md";
  std::map<std::string, int> counts;
  if (!fs::exists(list)) return counts;
  std::string exercise;
  for (const std::string& line : read_page(list).lines) {
    if (line.starts_with("### ")) exercise = line.substr(4, line.find(' ', 4) - 4);
    if (line.starts_with("- *")) ++counts[exercise];
  }
  return counts;
}

/// A row of the table with its last cell counted anew; any other line as it is.
std::string with_fresh_count(const std::map<std::string, int>& counts, const std::string& row) {
  if (!row.starts_with("| ")) return row;
  const auto found = counts.find(row.substr(2, row.find(' ', 2) - 2));
  const std::size_t last = row.rfind(" | ");
  if (found == counts.end() || last == std::string::npos) return row;
  return row.substr(0, last) + " | " + std::to_string(found->second) + " |";
}

}  // namespace

Page with_fresh_counts(const fs::path& root, const Page& page) {
  const std::map<std::string, int> counts = counts_of(root);
  Page fresh = page;
  bool in_table = false;
  for (std::string& line : fresh.lines) {
    in_table = line.starts_with("|") && (in_table || line.ends_with("the judge knows by name |"));
    if (in_table) line = with_fresh_count(counts, line);
  }
  return fresh;
}

std::vector<std::string> stale_counts(const fs::path& root, const Page& page) {
  const Page fresh = with_fresh_counts(root, page);
  std::vector<std::string> stale;
  for (std::size_t i = 0; i < page.lines.size(); ++i)
    if (fresh.lines[i] != page.lines[i])
      stale.push_back(at(page, i) + "the judge knows another number of ways to go wrong: " +
                      fresh.lines[i] + "; ./tumble book --write updates the page");
  return stale;
}

}  // namespace tumble::book
