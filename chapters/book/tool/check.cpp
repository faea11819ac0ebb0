#include "book/tool/check.hpp"

#include <algorithm>
#include <cctype>

#include "book/tool/exercises.hpp"
#include "book/tool/fences.hpp"
#include "book/tool/form.hpp"
#include "book/tool/known_mistakes.hpp"
#include "book/tool/links.hpp"
#include "book/tool/markdown_tables.hpp"
#include "book/tool/maths.hpp"
#include "book/tool/terms.hpp"
#include "book/tool/tex.hpp"
#include "book/tool/voice.hpp"
#include "support/table.hpp"

namespace tumble::book {

std::vector<fs::path> pages_of(const fs::path& root) {
  std::vector<fs::path> files{root / "README.md"};
  for (const auto& folder : fs::directory_iterator(root / "chapters"))
    if (fs::exists(folder.path() / "README.md"))
      for (const auto& entry : fs::directory_iterator(folder.path()))
        if (entry.path().extension() == ".md") files.push_back(entry.path());
  std::sort(files.begin() + 1, files.end());
  return files;
}

namespace {

/// Code and output that nothing keeps true.
std::vector<std::string> unannounced_fences(const Page& page) {
  std::vector<std::string> bad;
  for (const Fence& fence : fences_of(page))
    if (fence.source.empty() && fence.language != "math" && fence.language != "sh")
      bad.push_back(at(page, fence.opening) +
                    "nothing says where this comes from: announce it "
                    "with <!-- snippet: …#… -->, signature, output or measured");
  return bad;
}

/// Tables that the site would cut off.
std::vector<std::string> wide_tables(const Page& page) {
  constexpr std::size_t most = 97;  // characters that fit into the site's column
  std::vector<std::string> bad;
  for (const Fence& fence : fences_of(page)) {
    if (fence.language != "text") continue;
    std::size_t width = 0;
    for (std::size_t i = fence.opening + 1; i < fence.closing; ++i)
      width = std::max(width, support::characters(page.lines[i]));
    if (width > most)
      bad.push_back(at(page, fence.opening) + "this table is " + std::to_string(width) +
                    " characters wide, and " + std::to_string(most) + " fit");
  }
  return bad;
}

/// What is wrong with a formula in a line of text; empty if nothing is.
std::string mistake_of(const InlineFormula& formula, const std::string& line) {
  if (std::string what = mistake_in(formula.tex); !what.empty()) return what;
  const bool quoted = line[formula.begin + 1] == '`';
  if (const std::string trap = markdown_trap_in(formula.tex); !trap.empty() && !quoted)
    return "Markdown changes " + trap + " here: write $`…`$";
  const bool in_table = line.starts_with("|");
  if (in_table && formula.tex.find('|') != std::string::npos)
    return R"(| ends the cell of the table: write \lvert, \lVert or \mid)";
  return {};
}

/// A dollar that seems to begin or end a formula, but has no partner in its line.
bool has_lonely_dollar(const std::string& line, const std::vector<InlineFormula>& formulas) {
  const std::string visible = without_code_spans(line);
  for (std::size_t i = 0; i < visible.size(); ++i) {
    if (visible[i] != '$' || (i > 0 && visible[i - 1] == '\\')) continue;
    const bool inside = std::any_of(
        formulas.begin(), formulas.end(),
        [i](const InlineFormula& formula) { return formula.begin <= i && i < formula.end; });
    const bool price =
        i + 1 < visible.size() && std::isdigit(static_cast<unsigned char>(visible[i + 1])) != 0;
    if (!inside && !price) return true;
  }
  return false;
}

std::vector<std::string> bad_formulas(const Page& page) {
  std::vector<std::string> bad;
  const std::vector<Fence> fences = fences_of(page);
  for (const Fence& fence : fences)
    if (fence.language == "math")
      if (std::string what = mistake_in(content_of(page, fence)); !what.empty())
        bad.push_back(at(page, fence.opening) + what);
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    if (is_inside(fences, i)) continue;
    const std::vector<InlineFormula> formulas = formulas_in(page.lines[i]);
    if (has_lonely_dollar(page.lines[i], formulas))
      bad.push_back(at(page, i) + "this $ has no partner in its line");
    for (const InlineFormula& formula : formulas)
      if (std::string what = mistake_of(formula, page.lines[i]); !what.empty())
        bad.push_back(at(page, i) + what);
  }
  return bad;
}

std::vector<std::string> mistakes_in(const Places& places, const fs::path& file) {
  std::vector<std::string> mistakes;
  const auto add = [&](const std::vector<std::string>& more) {
    mistakes.insert(mistakes.end(), more.begin(), more.end());
  };
  try {
    const Page page = read_page(file);
    add(stale_fences(places, page));
    add(stale_exercises(places.root, page));
    add(stale_counts(places.root, page));
    add(unannounced_fences(page));
    add(wide_tables(page));
    add(broken_rows(page));
    add(bad_formulas(page));
    add(dead_links(page));
  } catch (const PageError& error) {
    add({error.what()});
  }
  return mistakes;
}

/// The pages that have not been rewritten yet: we check neither their voice nor their form, and
/// their bold type is not about terms.
std::vector<fs::path> pages_to_rewrite(const fs::path& root) {
  std::vector<fs::path> files;
  const fs::path list = root / "chapters/book/pages_to_rewrite.txt";
  if (!fs::exists(list)) return files;
  for (const std::string& line : read_page(list).lines)
    if (!line.empty() && !line.starts_with("#")) files.push_back(root / line);
  return files;
}

std::vector<Idiom> idioms_of(const fs::path& root) {
  const fs::path list = root / "chapters/book/idioms.txt";
  return fs::exists(list) ? read_idioms(list) : std::vector<Idiom>{};
}

/// How a page reads, if it has been rewritten; that it has been, if it reads well and is on the
/// list still.
std::vector<std::string> mistakes_of_style(const fs::path& root,
                                           const std::vector<fs::path>& pages) {
  const std::vector<fs::path> to_rewrite = pages_to_rewrite(root);
  const std::vector<Idiom> idioms = idioms_of(root);
  std::vector<std::string> mistakes;
  for (const fs::path& file : pages) {
    const Page page = read_page(file);
    std::vector<std::string> bad = mistakes_of_voice(page, idioms);
    if (is_chapter(file))
      for (const std::string& mistake : mistakes_of_form(root, page, pages)) bad.push_back(mistake);
    const bool listed = std::find(to_rewrite.begin(), to_rewrite.end(), file) != to_rewrite.end();
    const bool front = file == pages.front();  // another one in a hand-out
    if (listed && bad.empty() && !front)
      mistakes.push_back(at(page, 0) + "strike this page off chapters/book/pages_to_rewrite.txt");
    if (!listed) mistakes.insert(mistakes.end(), bad.begin(), bad.end());
  }
  return mistakes;
}

std::vector<Term> all_terms(const fs::path& root) {
  const std::vector<fs::path> to_rewrite = pages_to_rewrite(root);
  std::vector<Term> terms;
  for (const fs::path& file : pages_of(root)) {
    const bool listed = std::find(to_rewrite.begin(), to_rewrite.end(), file) != to_rewrite.end();
    if (listed || !is_chapter(file)) continue;
    for (Term& term : terms_of(read_page(file))) terms.push_back(std::move(term));
  }
  return terms;
}

std::vector<std::string> mistakes_of_terms(const fs::path& root) {
  std::vector<std::string> mistakes = repeated(all_terms(root));
  const fs::path place = place_of_terms(root);
  if (!fs::exists(place) || read_page(place).lines != fresh_terms(root).lines)
    mistakes.push_back(place.string() +
                       ":1: is not what the pages say; ./tumble book --write updates the page");
  return mistakes;
}

}  // namespace

Page fresh_terms(const fs::path& root) { return page_of_terms(root, all_terms(root)); }

std::vector<std::string> mistakes_in(const Places& places) {
  std::vector<std::string> mistakes;
  const auto add = [&](const std::vector<std::string>& more) {
    mistakes.insert(mistakes.end(), more.begin(), more.end());
  };
  const std::vector<fs::path> pages = pages_of(places.root);
  for (const fs::path& file : pages) add(mistakes_in(places, file));
  try {
    add(mistakes_of_style(places.root, pages));
    add(mistakes_of_terms(places.root));
  } catch (const PageError& error) {
    add({error.what()});
  }
  return mistakes;
}

}  // namespace tumble::book
