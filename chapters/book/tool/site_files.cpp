#include "book/tool/site_files.hpp"

#include <algorithm>
#include <set>

#include "book/tool/addresses.hpp"
#include "book/tool/check.hpp"
#include "book/tool/fences.hpp"
#include "book/tool/links.hpp"

namespace tumble::book {

namespace {

/// The files that a page links to, without the drawings.
std::vector<fs::path> targets_of(const Page& page) {
  std::vector<fs::path> targets;
  const std::vector<Fence> fences = fences_of(page);
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    if (is_inside(fences, i)) continue;
    for (const Link& link : links_in(page.lines[i])) {
      const std::string path = link.target.substr(0, link.target.find('#'));
      const fs::path file = page.file.parent_path() / path;
      if (path.empty() || link.image || !fs::exists(file)) continue;
      targets.push_back(
          fs::is_directory(file) && fs::exists(file / "README.md") ? file / "README.md" : file);
    }
  }
  return targets;
}

class Walk {
 public:
  explicit Walk(const fs::path& root) : root_(fs::canonical(root)) {}

  SiteFiles files() {
    for (const fs::path& page : pages_of(root_)) add(page);
    add(root_ / "lib/README.md");
    for (std::size_t read = 0; read < files_.pages.size();) {  // the list grows meanwhile
      const fs::path page = files_.pages[read++];
      for (const fs::path& target : targets_of(read_page(page))) add(target);
    }
    std::sort(files_.exercises.begin(), files_.exercises.end());
    return files_;
  }

 private:
  void add(const fs::path& file) {
    if (!fs::exists(file)) return;
    const fs::path exercises = exercise_folder(root_, file);
    const fs::path what = fs::canonical(exercises.empty() ? file : exercises);
    if (is_public_header(root_, what) || !seen_.insert(what).second) return;
    if (!exercises.empty())
      files_.exercises.push_back(what);
    else if (what.extension() == ".md")
      files_.pages.push_back(what);
    else
      files_.shown.push_back(what);
  }

  fs::path root_;
  std::set<fs::path> seen_;
  SiteFiles files_;
};

}  // namespace

SiteFiles site_files(const fs::path& root) { return Walk(root).files(); }

}  // namespace tumble::book
