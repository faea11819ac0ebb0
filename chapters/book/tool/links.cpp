#include "book/tool/links.hpp"

#include <algorithm>

#include "book/tool/fences.hpp"
#include "support/heading_anchor.hpp"

namespace tumble::book {

std::vector<Link> links_in(const std::string& line) {
  std::vector<Link> links;
  const std::string visible = without_code_spans(line);
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (visible[i] != '[') continue;
    int depth = 0;
    std::size_t close = i;
    for (; close < line.size(); ++close) {
      if (visible[close] == '[') ++depth;
      if (visible[close] == ']' && --depth == 0) break;
    }
    if (close + 1 >= line.size() || line[close + 1] != '(') continue;
    const auto end = line.find(')', close);
    if (end == std::string::npos) continue;
    const bool image = i > 0 && line[i - 1] == '!';
    links.push_back({image ? i - 1 : i, end + 1, image, line.substr(i + 1, close - i - 1),
                     line.substr(close + 2, end - close - 2)});
    i = end;
  }
  return links;
}

std::string anchor_of(const std::string& heading) { return support::heading_anchor(heading); }

Heading heading_in(const std::string& line) {
  const auto level = line.find_first_not_of('#');
  if (level == 0 || level == std::string::npos || level > 6 || line[level] != ' ') return {};
  return {level, line.substr(level + 1)};
}

namespace {

bool has_anchor(const fs::path& file, const std::string& anchor) {
  const Page page = read_page(file);
  const std::vector<Fence> fences = fences_of(page);
  for (std::size_t i = 0; i < page.lines.size(); ++i)
    if (!is_inside(fences, i) && anchor_of(heading_in(page.lines[i]).text) == anchor) return true;
  return false;
}

std::string why_dead(const Page& page, const std::string& target) {
  if (target.find("://") != std::string::npos || target.starts_with("mailto:")) return {};
  const auto hash = target.find('#');
  const std::string path = target.substr(0, hash);
  const fs::path file = path.empty() ? page.file : page.file.parent_path() / path;
  if (!fs::exists(file)) return "there is no " + path;
  if (hash == std::string::npos || file.extension() != ".md") return {};
  const std::string anchor = target.substr(hash + 1);
  return has_anchor(file, anchor) ? "" : "there is no heading #" + anchor;
}

}  // namespace

std::vector<std::string> dead_links(const Page& page) {
  std::vector<std::string> dead;
  const std::vector<Fence> fences = fences_of(page);
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    if (is_inside(fences, i)) continue;
    const std::string& line = page.lines[i];
    const auto complain = [&](const std::string& what) {
      dead.push_back(page.file.string() + ":" + std::to_string(i + 1) + ": " + what);
    };
    const std::vector<Link> links = links_in(line);
    const std::string visible = without_code_spans(line);
    for (auto at = visible.find("]("); at != std::string::npos; at = visible.find("](", at + 1)) {
      const bool known = std::any_of(links.begin(), links.end(), [at](const Link& link) {
        return link.begin <= at && at < link.end;
      });
      if (!known) complain("a link has to be in one line, from [ to )");
    }
    for (const Link& link : links) {
      if (const std::string why = why_dead(page, link.target); !why.empty()) complain(why);
      if (link.image && (link.begin != 0 || link.end != line.size()))
        complain("a figure has to be in a line of its own");
    }
    if (visible.find("<img") != std::string::npos)
      complain("a figure is written as ![caption](file)");
  }
  return dead;
}

}  // namespace tumble::book
