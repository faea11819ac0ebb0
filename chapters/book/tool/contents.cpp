#include "book/tool/contents.hpp"

#include <map>

#include "book/tool/addresses.hpp"
#include "book/tool/boxes.hpp"
#include "book/tool/fences.hpp"
#include "book/tool/html.hpp"
#include "book/tool/links.hpp"

namespace tumble::book {

std::string heading_id(const fs::path& root, const Page& page, const std::string& heading) {
  return page_id(root, page.file) + "-" + anchor_of(heading);
}

std::string neighbours_html(const fs::path& root, const Page& page) {
  const std::string& last = page.lines.back();
  if (last.find("[Terms](") == std::string::npos) return {};
  std::string links;
  for (const Link& link : links_in(last)) {
    const bool before = link.text.starts_with("←"), after = link.text.ends_with("→");
    const std::string relation = before ? " rel=\"prev\"" : after ? " rel=\"next\"" : "";
    links += "<a" + relation + " href=\"" +
             address_of(root, page.file.parent_path() / link.target) + "\">" +
             inline_html(link.text) + "</a>";
  }
  return R"(<nav class="neighbours" aria-label="Neighbouring chapters">)" + links + "</nav>";
}

namespace {

std::string item(const std::string& style, const std::string& id, const std::string& text) {
  return "<li class=\"" + style + "\">" + link_html("#" + id, inline_html(text)) + "</li>";
}

/// Where on the page each exercise is written: line → "4.1".
std::map<std::size_t, std::string> exercises_by_line(const Page& page) {
  std::map<std::size_t, std::string> exercises;
  for (const Box& box : boxes_of(page))
    if (!box.exercise.empty()) exercises[box.first] = box.exercise;
  return exercises;
}

}  // namespace

std::string contents_html(const fs::path& root, const Page& page) {
  const std::vector<Fence> fences = fences_of(page);
  const auto exercises = exercises_by_line(page);
  std::string items;
  std::size_t count = 0;
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    if (const auto exercise = exercises.find(i); exercise != exercises.end())
      items += item("level3", box_id(exercise->second), "Now write " + exercise->second);
    const Heading heading = heading_in(page.lines[i]);
    if (is_inside(fences, i) || heading.level < 2 || heading.level > 3) continue;
    items += item("level" + std::to_string(heading.level), heading_id(root, page, heading.text),
                  heading.text);
    ++count;
  }
  if (count < 3) return {};
  return "<nav class=\"page-contents\" aria-label=\"On this page\"><details open><summary>On this "
         "page</summary><ul>" +
         items + "</ul></details></nav>";
}

}  // namespace tumble::book
