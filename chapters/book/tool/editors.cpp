#include "book/tool/editors.hpp"

#include <map>
#include <sstream>
#include <stdexcept>

#include "book/tool/html.hpp"

namespace tumble::book {

namespace {

const std::string box = R"(<div class="now-write" id="now-write-)";
/// A page that is opened from disk may load no module, and shows the commands alone.
const std::string script =
    "<script class=\"editors\">if (location.protocol !== \"file:\") "
    "import(\"./exercises/exercise.mjs\");</script>\n";

void demand(const fs::path& folder, const std::vector<std::string>& names) {
  std::string missing;
  for (const std::string& name : names)
    if (!fs::exists(folder / name)) missing += (missing.empty() ? "" : ", ") + name;
  if (!missing.empty())
    throw std::invalid_argument(folder.string() + " is not complete: it has no " + missing);
}

/// The exercises of a page: "4.1" of a box that is called "now-write-4.1".
std::vector<std::string> exercises_on(const std::string& text) {
  std::vector<std::string> numbers;
  for (auto at = text.find(box); at != std::string::npos; at = text.find(box, at + 1)) {
    const std::size_t begin = at + box.size();
    numbers.push_back(text.substr(begin, text.find('"', begin) - begin));
  }
  return numbers;
}

void add_script(const fs::path& page, std::string& text) {
  if (text.find(script) != std::string::npos) return;
  const std::size_t end = text.rfind("</body>");
  if (end == std::string::npos)
    throw std::invalid_argument(page.string() + " is no page: it has no </body>");
  text.insert(end, script);
}

/// The pages that people read: on the one that is printed nobody writes.
std::vector<fs::path> pages_in(const fs::path& site) {
  std::vector<fs::path> pages;
  for (const auto& entry : fs::directory_iterator(site))
    if (entry.path().extension() == ".html" && entry.path().filename() != "print.html")
      pages.push_back(entry.path());
  return pages;
}

/// @return {"4.1": "chapters-04_quaternions.html", …}
std::string as_json(const std::map<std::string, std::string>& page_of) {
  std::ostringstream json;
  for (const auto& [number, page] : page_of)
    json << (json.tellp() > 0 ? ",\n" : "{\n") << "  \"" << number << "\": \"" << page << "\"";
  json << "\n}\n";
  return json.str();
}

void copy_exercises(const fs::path& site, const fs::path& folder) {
  fs::remove_all(site / "exercises");
  fs::copy(folder, site / "exercises", fs::copy_options::recursive);
  fs::rename(site / "exercises/service_worker.js", site / "service_worker.js");
}

}  // namespace

void add_editors(const fs::path& site, const fs::path& folder) {
  demand(site, {"index.html"});
  demand(folder,
         {"manifest.json", "units.json", "exercise.mjs", "exercise.css", "client.mjs",
          "service_worker.js", "codemirror/codemirror.js", "codemirror/codemirror.css",
          "codemirror/clike.js", "codemirror/matchbrackets.js", "codemirror/closebrackets.js"});
  copy_exercises(site, folder);
  std::map<std::string, std::string> page_of;
  for (const fs::path& page : pages_in(site)) {
    std::string text = text_of(page);
    const std::vector<std::string> numbers = exercises_on(text);
    const bool has_figure = text.find("data-figure=") != std::string::npos;  // it may ask a reader
    if (numbers.empty() && !has_figure && page.filename() != "index.html") continue;
    for (const std::string& number : numbers) page_of[number] = page.filename().string();
    add_script(page, text);
    write_text(page, text);
  }
  write_text(site / "exercises/pages.json", as_json(page_of));
}

}  // namespace tumble::book
