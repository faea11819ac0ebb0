#include "book/tool/prepare.hpp"

#include "book/tool/addresses.hpp"
#include "book/tool/converter.hpp"
#include "book/tool/exercise_pages.hpp"
#include "book/tool/html.hpp"
#include "book/tool/markdown_tables.hpp"
#include "book/tool/sidebar.hpp"
#include "book/tool/site_files.hpp"
#include "book/tool/source_pages.hpp"

namespace tumble::book {

namespace {

/// Not .md: what is converted already does not go through the filter.
void write_converted(const fs::path& root, const fs::path& folder, const Page& page) {
  write_text(folder / (page_id(root, page.file) + ".markdown"), for_doxygen(root, page));
}

std::string replaced(std::string text, const std::string& mark, const std::string& by) {
  const auto at = text.find(mark);
  if (at == std::string::npos) throw PageError("the theme's header.html:1: has no " + mark);
  return text.replace(at, mark.size(), by);
}

}  // namespace

void prepare_site(const fs::path& any_root, const fs::path& theme, const fs::path& site) {
  const fs::path root = fs::canonical(any_root);
  const SiteFiles files = site_files(root);
  const fs::path pages = site / "pages";
  fs::remove_all(pages);
  for (const fs::path& folder : files.exercises)
    write_converted(root, pages, exercise_page(root, folder));
  for (const fs::path& file : files.shown) write_converted(root, pages, source_page(root, file));
  write_text(pages / "folders.dox", folder_briefs(root));
  write_text(site / "header.html", replaced(text_of(theme / "header.html"), "<!-- all pages -->",
                                            sidebar_html(root, files)));
  std::string inputs = "INPUT =";
  for (const fs::path& file : files.pages) {
    if (const auto broken = broken_rows(read_page(file)); !broken.empty())
      throw PageError(broken.front());
    inputs += " \"" + file.string() + "\"";
  }
  write_text(site / "inputs.doxy", inputs + " \"" + pages.string() + "\"\n");
}

}  // namespace tumble::book
