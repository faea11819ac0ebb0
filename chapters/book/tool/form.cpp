#include "book/tool/form.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "book/tool/exercises.hpp"
#include "book/tool/figures.hpp"
#include "book/tool/links.hpp"

namespace tumble::book {

namespace {

int chapter_number(const fs::path& file) {
  return std::atoi(file.parent_path().filename().string().c_str());
}

std::size_t lines_that_begin(const Page& page, const std::string& start) {
  return static_cast<std::size_t>(
      std::count_if(page.lines.begin(), page.lines.end(),
                    [&start](const std::string& line) { return line.starts_with(start); }));
}

/// "[← 8 Mirtich](../08_mirtich/README.md)"; empty if that page is not of this chapter or the next
/// one.
std::string link_to(const Page& page, const fs::path& other, bool before) {
  if (!is_chapter(other) || std::abs(chapter_number(other) - chapter_number(page.file)) > 1)
    return {};
  const std::string title = heading_in(read_page(other).lines.at(0)).text;
  return "[" + (before ? "← " + title : title + " →") + "](" +
         other.lexically_relative(page.file.parent_path()).string() + ")";
}

/// How many figures the chapter has on the pages before this one: we number them through.
std::size_t figures_before(const Page& page, const std::vector<fs::path>& pages) {
  std::size_t count = 0;
  for (const fs::path& other : pages) {
    if (other == page.file) break;
    if (other.parent_path() == page.file.parent_path())
      count += figures_of(read_page(other)).size();
  }
  return count;
}

std::vector<std::string> bad_figures(const Page& page, const std::vector<fs::path>& pages) {
  std::vector<std::string> bad;
  const std::vector<Figure> figures = figures_of(page);
  const std::size_t before = figures_before(page, pages);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const std::string start = "Figure " + std::to_string(chapter_number(page.file)) + "." +
                              std::to_string(before + i + 1) + ". ";
    if (!figures[i].caption.starts_with(start))
      bad.push_back(at(page, figures[i].line) +
                    "two lines below this figure its caption is missing: *" + start + "…*");
  }
  return bad;
}

/// Each exercise of the contract has one block in the chapter's first page.
std::vector<std::string> missing_exercises(const fs::path& root, const Page& page) {
  std::vector<std::string> bad;
  const std::vector<ExerciseBlock> blocks = exercise_blocks(page);
  for (const std::string& number : exercises_in(contract_of(root, page))) {
    const auto times =
        std::count_if(blocks.begin(), blocks.end(),
                      [&number](const ExerciseBlock& block) { return block.number == number; });
    if (times != 1)
      bad.push_back(at(page, 0)
                        .append("exercise ")
                        .append(number)
                        .append(" has ")
                        .append(std::to_string(times))
                        .append(" blocks <!-- exercise: ")
                        .append(number)
                        .append(" -->, and should have one"));
  }
  return bad;
}

std::vector<std::string> missing_parts(const Page& page) {
  std::vector<std::string> bad;
  if (lines_that_begin(page, "> **Try it.**") < 3)
    bad.push_back(at(page, 0) + "a chapter has at least three questions: > **Try it.** …");
  for (const std::string heading : {"## What we have now", "## Challenges"})
    if (lines_that_begin(page, heading) != 1)
      bad.push_back(at(page, 0) + "a chapter ends with a section " + heading);
  return bad;
}

}  // namespace

bool is_chapter(const fs::path& file) {
  const std::string folder = file.parent_path().filename().string();
  return folder.size() > 3 && std::isdigit(static_cast<unsigned char>(folder[0])) != 0 &&
         folder[2] == '_';
}

std::string neighbours(const Page& page, const std::vector<fs::path>& pages) {
  const auto here = std::find(pages.begin(), pages.end(), page.file);
  std::string line;
  const auto add = [&line](const std::string& link) {
    line += (line.empty() || link.empty() ? "" : " · ") + link;
  };
  if (here != pages.begin()) add(link_to(page, *std::prev(here), true));
  add("[Terms](../terms/README.md)");
  if (std::next(here) != pages.end()) add(link_to(page, *std::next(here), false));
  return line;
}

std::vector<std::string> mistakes_of_form(const fs::path& root, const Page& page,
                                          const std::vector<fs::path>& pages) {
  std::vector<std::string> bad = bad_figures(page, pages);
  const auto add = [&bad](const std::vector<std::string>& more) {
    bad.insert(bad.end(), more.begin(), more.end());
  };
  if (page.file.filename() == "README.md") {
    add(missing_exercises(root, page));
    add(missing_parts(page));
  }
  if (const std::string line = neighbours(page, pages); page.lines.back() != line)
    bad.push_back(at(page, page.lines.size() - 1) + "the page ends with the line " + line);
  return bad;
}

}  // namespace tumble::book
