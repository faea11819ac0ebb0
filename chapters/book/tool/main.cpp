/// @file
/// Keeps the pages true, and turns them into what Doxygen reads.
#include <iostream>

#include "book/tool/check.hpp"
#include "book/tool/converter.hpp"
#include "book/tool/dead_ends.hpp"
#include "book/tool/editors.hpp"
#include "book/tool/exercises.hpp"
#include "book/tool/finish.hpp"
#include "book/tool/html.hpp"
#include "book/tool/known_mistakes.hpp"
#include "book/tool/page_numbers.hpp"
#include "book/tool/prepare.hpp"
#include "book/tool/printed.hpp"
#include "book/tool/reference_links.hpp"
#include "book/tool/search_index.hpp"
#include "book/tool/site_files.hpp"
#include "book/tool/sources.hpp"
#include "book/tool/terms.hpp"
#include "support/command_line.hpp"

using namespace tumble::book;

namespace {

/// All pages or, if something goes wrong, none.
void write_all(const Places& places) {
  std::vector<Page> changed;
  for (const fs::path& file : pages_of(places.root)) {
    const Page page = read_page(file);
    const Page exercises = with_fresh_exercises(places.root, page);
    const Page fresh = refreshed(places, with_fresh_counts(places.root, exercises));
    if (fresh.lines != page.lines) changed.push_back(fresh);
  }
  for (const Page& page : changed) write_page(page);
  fs::create_directories(place_of_terms(places.root).parent_path());
  write_page(fresh_terms(places.root));
}

int print_mistakes(const std::vector<std::string>& mistakes) {
  for (const std::string& mistake : mistakes) std::cout << mistake << "\n";
  using namespace tumble::support;
  return mistakes.empty() ? exit_status::achieved : exit_status::not_achieved;
}

int finish(const fs::path& root, const fs::path& site) {
  finish_site(root, site / "html");
  write_printed_book(fs::canonical(root), site_files(root), site / "html");
  const fs::path library = site / "html/lib.html", tags = site / "names.tag";
  write_text(library, with_reference_links(text_of(library), names_in(text_of(tags))));
  write_search_index(root, tags, site / "html/search_index.js");
  std::vector<std::string> dead = dead_ends(site / "html");
  for (std::string& link : dead) link.insert(0, "a link of the site leads nowhere: ");
  return print_mistakes(dead);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("the pages of the book", "tumble_book");
  app.require_subcommand(1);
  Places places;
  fs::path file, theme, made;
  app.add_option("--root", places.root, "of the project")->required();
  app.add_option("--programs", places.programs, "folder with the chapters' programs");
  CLI::App* checking = app.add_subcommand("check", "code, numbers, formulas and links are true");
  CLI::App* writing = app.add_subcommand("write", "fill in code and numbers anew");
  CLI::App* filter = app.add_subcommand("filter", "one page for Doxygen");
  filter->add_option("file", file)->required();
  CLI::App* preparing = app.add_subcommand("prepare", "write what Doxygen reads beside the pages");
  preparing->add_option("theme", theme)->required();
  CLI::App* finishing = app.add_subcommand("finish", "complete the pages that Doxygen has made");
  CLI::App* exercises = app.add_subcommand("exercises", "put editors into a site that is there");
  exercises->add_option("site", file, "the folder with index.html")->required();
  exercises->add_option("folder", made, "what was made for the exercises")->required();
  CLI::App* numbering = app.add_subcommand("number", "page numbers into the printed contents");
  numbering->add_option("page", file, "print.html")->required();
  numbering->add_option("pdf", made, "that page, printed")->required();
  for (CLI::App* each : {preparing, finishing}) each->add_option("site", file)->required();
  return tumble::support::run_command_line(app, argc, argv, [&] {
    if (*checking) return print_mistakes(mistakes_in(places));
    if (*writing) write_all(places);
    if (*filter) std::cout << for_doxygen(places.root, read_page(file));
    if (*preparing) prepare_site(places.root, theme, file);
    if (*exercises) add_editors(file, made);
    if (*numbering)
      write_text(file, with_page_numbers(text_of(file), pages_of_places(text_of(made))));
    if (*finishing) return finish(places.root, file);
    return tumble::support::exit_status::achieved;
  });
}
