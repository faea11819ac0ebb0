#include "judge/handout/dead_links.hpp"

#include <algorithm>
#include <regex>
#include <sstream>

namespace tumble::judge {

namespace fs = std::filesystem;

namespace {

/// [words](target), an image too; first the words, then the target.
constexpr const char* a_link = R"(!?\[([^\[\]]*)\]\(([^()\s]+)\))";

/// A page, and where its links may lead.
class MarkdownPage {
 public:
  MarkdownPage(fs::path page, const std::set<fs::path>& paths)
      : page_(std::move(page)), paths_(paths) {}

  /// Prose, without fences.
  std::string cleaned(const std::string& prose) const {
    return without_links(without_items(without_lines(prose)));
  }

 private:
  /// Whether a link leads to a file or folder that is handed out, or out of the tree.
  bool leads_somewhere(const std::string& link) const {
    const std::string target = link.substr(0, link.find('#'));
    if (target.empty() || target.find("://") != std::string::npos) return true;
    fs::path path = (page_.parent_path() / target).lexically_normal();
    if (!path.has_filename()) path = path.parent_path();
    return std::any_of(paths_.begin(), paths_.end(), [&](const fs::path& each) {
      return each == path || each.string().starts_with(path.string() + "/");
    });
  }

  /// Without rows of tables and items of lists that begin with a dead link, and the lines that such
  /// an item goes on in.
  std::string without_lines(const std::string& prose) const {
    static const std::regex about(std::string("^(\\|| *[-*]) *") + a_link);
    std::istringstream in(prose);
    std::string result;
    bool left_out = false;
    std::smatch match;
    for (std::string line; std::getline(in, line);) {
      if (std::regex_search(line, match, about))
        left_out = !leads_somewhere(match[3]);
      else if (!line.starts_with("  ") || line.find_first_not_of(' ') == std::string::npos)
        left_out = false;
      if (!left_out) result += line + "\n";
    }
    return result;
  }

  /// Without the dead ones of links between · and ·.
  std::string without_items(const std::string& prose) const {
    static const std::regex item(std::string("(\\s*·\\s*)?") + a_link + "(?=(\\s*·)?)");
    bool first_is_gone = false;
    return replaced(prose, item, [&](const std::smatch& match) {
      const bool is_first = match[1].length() == 0 || first_is_gone;
      const bool in_list = match[1].length() > 0 || match[4].length() > 0;
      first_is_gone = in_list && is_first && !leads_somewhere(match[3]);
      if (in_list && !leads_somewhere(match[3])) return std::string();
      return is_first ? match.str().substr(match[1].str().size()) : match.str();
    });
  }

  std::string without_links(const std::string& prose) const {
    static const std::regex link(a_link);
    return replaced(prose, link, [&](const std::smatch& match) {
      return leads_somewhere(match[2]) ? match.str() : match[1].str();
    });
  }

  template <class Replacement>
  static std::string replaced(const std::string& text, const std::regex& what,
                              Replacement&& replacement) {
    std::string result;
    auto rest = text.begin();
    for (std::sregex_iterator it(text.begin(), text.end(), what), end; it != end; ++it) {
      result.append(rest, text.begin() + it->position());
      rest = text.begin() + it->position() + it->length();
      result += replacement(*it);
    }
    return result.append(rest, text.end());
  }

  fs::path page_;
  const std::set<fs::path>& paths_;
};

}  // namespace

std::string without_dead_links(const std::string& text, const fs::path& path,
                               const std::set<fs::path>& paths) {
  const MarkdownPage page(path, paths);
  std::istringstream in(text);
  std::string result, prose;
  bool code = false;
  for (std::string line; std::getline(in, line);) {
    const bool fence = line.starts_with("```") || line.starts_with("> ```");  // in a box, too
    if (fence) code = !code;
    prose += line + "\n";
    if (fence) {  // a link may go over two lines, but not into a fence
      result += code ? page.cleaned(prose) : prose;
      prose.clear();
    }
  }
  return result + page.cleaned(prose);
}

}  // namespace tumble::judge
