#include "book/tool/reference_links.hpp"

#include <map>

#include "book/tool/html.hpp"

namespace tumble::book {

namespace {

/// What is there without Doxygen's own links.
std::string without_tags(std::string html) {
  for (auto tag = html.find('<'); tag != std::string::npos; tag = html.find('<'))
    html.erase(tag, html.find('>', tag) - tag + 1);
  return html;
}

/// In a sentence `tumble::compiled` may be CMake's target.
bool begins_a_cell(const std::string& html, std::size_t at) {
  const auto cell = html.rfind("<td", at);
  return cell != std::string::npos && without_tags(html.substr(cell, at - cell)).empty();
}

}  // namespace

std::string with_reference_links(const std::string& html, const std::vector<Entry>& names) {
  std::map<std::string, std::string> addresses;
  for (const Entry& name : names) addresses.try_emplace(name.section, name.address);
  const std::string start = "<code>", end = "</code>";
  std::string result, scope = "tumble";
  std::size_t at = 0;
  for (auto begin = html.find(start); begin != std::string::npos; begin = html.find(start, at)) {
    const auto stop = html.find(end, begin);
    const std::string name =
        without_tags(html.substr(begin + start.size(), stop - begin - start.size()));
    if (name.starts_with("tumble::") && begins_a_cell(html, begin)) scope = name;
    const auto address = addresses.find(std::string(scope).append("::").append(name));
    const std::string code = html.substr(begin, stop + end.size() - begin);
    result += html.substr(at, begin - at) +
              (address == addresses.end() ? code : link_html(address->second, code));
    at = stop + end.size();
  }
  return result + html.substr(at);
}

}  // namespace tumble::book
