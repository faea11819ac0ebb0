#include "book/tool/dead_ends.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "book/tool/html.hpp"

namespace tumble::book {

namespace {

/// The values of an attribute: all of `name="…"` in a text of HTML.
std::set<std::string> values_of(const std::string& html, const std::string& name) {
  std::set<std::string> values;
  const std::string start = " " + name + "=\"";
  for (auto at = html.find(start); at != std::string::npos; at = html.find(start, at + 1)) {
    const auto begin = at + start.size();
    values.insert(html.substr(begin, html.find('"', begin) - begin));
  }
  return values;
}

bool is_elsewhere(const std::string& address) {
  const auto colon = address.find(':');
  return colon != std::string::npos && address.find_first_of("/#?") > colon;
}

/// "%20" and "&amp;" as the characters that they stand for.
std::string decoded(const std::string& address) {
  std::string text;
  for (std::size_t i = 0; i < address.size(); ++i) {
    if (address[i] == '%' && i + 2 < address.size()) {
      text += static_cast<char>(std::stoi(address.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else if (address.compare(i, 5, "&amp;") == 0) {
      text += '&';
      i += 4;
    } else {
      text += address[i];
    }
  }
  return text;
}

class Site {
 public:
  explicit Site(const fs::path& folder) : folder_(folder) {}

  bool leads_somewhere(const std::string& page, const std::string& address) {
    if (address.empty() || is_elsewhere(address)) return true;
    const auto hash = address.find('#');
    const std::string path = decoded(address.substr(0, hash));
    const std::string file = path.empty() ? page : path;
    if (!fs::exists(folder_ / file)) return false;
    if (hash == std::string::npos || !file.ends_with(".html")) return true;
    const std::string place = decoded(address.substr(hash + 1));
    return place.empty() || places_of(file).contains(place);
  }

 private:
  const std::set<std::string>& places_of(const std::string& file) {
    const auto [it, fresh] = places_.try_emplace(file);
    if (fresh) {
      const std::string html = text_of(folder_ / file);
      it->second = values_of(html, "id");
      it->second.merge(values_of(html, "name"));
    }
    return it->second;
  }

  fs::path folder_;
  std::map<std::string, std::set<std::string>> places_;
};

}  // namespace

std::vector<std::string> dead_ends(const fs::path& folder) {
  std::vector<std::string> dead;
  Site site(folder);
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".html") continue;
    const std::string page = entry.path().filename().string(), html = text_of(entry.path());
    for (const char* attribute : {"href", "src"})
      for (const std::string& address : values_of(html, attribute))
        if (!site.leads_somewhere(page, address))
          dead.push_back(std::string(page).append(": ").append(address));
  }
  std::sort(dead.begin(), dead.end());
  return dead;
}

}  // namespace tumble::book
