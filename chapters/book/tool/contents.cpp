#include "book/tool/contents.hpp"

#include "book/tool/addresses.hpp"
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

std::string contents_html(const fs::path& root, const Page& page) {
  const std::vector<Fence> fences = fences_of(page);
  std::string items;
  std::size_t count = 0;
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    const Heading heading = heading_in(page.lines[i]);
    if (is_inside(fences, i) || heading.level < 2 || heading.level > 3) continue;
    items += "<li class=\"level" + std::to_string(heading.level) + "\">" +
             link_html("#" + heading_id(root, page, heading.text), inline_html(heading.text)) +
             "</li>";
    ++count;
  }
  if (count < 3) return {};
  return "<nav class=\"page-contents\" aria-label=\"On this page\"><details open><summary>On this "
         "page</summary><ul>" +
         items + "</ul></details></nav>";
}

}  // namespace tumble::book
