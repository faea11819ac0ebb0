/// @file
/// Keeps the pages true, and turns them into what Doxygen reads.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "book/tool/links.hpp"
#include "book/tool/maths.hpp"
#include "book/tool/site.hpp"
#include "book/tool/sources.hpp"

using namespace tumble::book;

namespace {

/// The pages of the book: the front page and one a folder of chapters/.
std::vector<fs::path> pages_of(const fs::path& root) {
  std::vector<fs::path> files{root / "README.md"};
  for (const auto& entry : fs::directory_iterator(root / "chapters"))
    if (fs::exists(entry.path() / "README.md")) files.push_back(entry.path() / "README.md");
  std::sort(files.begin() + 1, files.end());
  return files;
}

std::vector<std::string> bad_formulas(const Page& page) {
  std::vector<std::string> bad;
  const auto complain = [&](std::size_t line, const std::string& what) {
    bad.push_back(page.file.string() + ":" + std::to_string(line + 1) + ": " + what);
  };
  const std::vector<Fence> fences = fences_of(page);
  for (const Fence& fence : fences)
    if (fence.language == "math")
      if (const std::string what = mistake_in(content_of(page, fence)); !what.empty())
        complain(fence.opening, what);
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    if (is_inside(fences, i)) continue;
    for (const InlineFormula& formula : formulas_in(page.lines[i])) {
      if (const std::string what = mistake_in(formula.tex); !what.empty()) complain(i, what);
      const bool quoted = page.lines[i][formula.begin + 1] == '`';
      if (const std::string trap = markdown_trap_in(formula.tex); !trap.empty() && !quoted)
        complain(i, "Markdown eats the backslash of " + trap + ": write $`…`$");
    }
  }
  return bad;
}

/// @return the number of mistakes
std::size_t check(const Places& places) {
  std::vector<std::string> mistakes;
  const auto add = [&](const std::vector<std::string>& more) {
    mistakes.insert(mistakes.end(), more.begin(), more.end());
  };
  for (const fs::path& file : pages_of(places.root)) {
    const Page page = read_page(file);
    add(stale_fences(places, page));
    add(bad_formulas(page));
    add(dead_links(page));
  }
  for (const std::string& mistake : mistakes) std::cout << mistake << "\n";
  return mistakes.size();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("the pages of the book");
  app.require_subcommand(1);
  Places places;
  fs::path file;
  app.add_option("--root", places.root, "of the project")->required();
  app.add_option("--programs", places.programs, "folder with the chapters' programs");
  CLI::App* checking = app.add_subcommand("check", "code, numbers, formulas and links are true");
  CLI::App* writing = app.add_subcommand("write", "fill in code and numbers anew");
  CLI::App* filter = app.add_subcommand("filter", "one page for Doxygen");
  filter->add_option("file", file)->required();
  CLI::App* figures = app.add_subcommand("figures", "put the drawings into Doxygen's pages");
  figures->add_option("folder", file)->required();
  CLI11_PARSE(app, argc, argv);
  try {
    if (*checking) return check(places) == 0 ? 0 : 1;
    if (*writing)
      for (const fs::path& page : pages_of(places.root))
        write_page(refreshed(places, read_page(page)));
    if (*figures)
      for (const auto& entry : fs::directory_iterator(file))
        if (entry.path().filename().string().starts_with("chapters-"))
          fill_in_figures(places.root, entry.path());
    if (*filter) std::cout << for_doxygen(places.root, read_page(file));
    return 0;
  } catch (const std::exception& e) {
    std::cerr << e.what() << "\n";
    return 2;
  }
}
