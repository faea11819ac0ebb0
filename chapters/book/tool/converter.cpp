#include "book/tool/converter.hpp"

#include <algorithm>
#include <cctype>
#include <map>

#include "book/tool/addresses.hpp"
#include "book/tool/boxes.hpp"
#include "book/tool/contents.hpp"
#include "book/tool/exercises.hpp"
#include "book/tool/fences.hpp"
#include "book/tool/figures.hpp"
#include "book/tool/html.hpp"
#include "book/tool/links.hpp"
#include "book/tool/maths.hpp"
#include "book/tool/number_tables.hpp"
#include "book/tool/wording.hpp"

namespace tumble::book {

namespace {

/// The place of a drawing of 100 kB, which Doxygen's scanner could not take: finish_site() fills
/// it.
std::string drawing_html(const std::string& svg) {
  return "<div data-figure=\"" + svg + "\"></div>";
}

class Converter {
 public:
  Converter(const fs::path& root, const Page& page)
      : root_(root),
        page_(page),
        fences_(fences_of(page)),
        figures_(figures_of(page)),
        boxes_(boxes_of(page)) {}

  std::string convert() {
    std::string text;
    for (std::size_t i = 0; i < page_.lines.size(); ++i) text += line(i) + "\n";
    return text;
  }

 private:
  /// The line between two boxes ends the one and begins the other.
  std::string box_edges(std::size_t i) const {
    std::string ends, begins;
    for (const Box& box : boxes_) {
      if (i == box.end) ends = "</div>";
      if (i + 1 == box.first) begins = opening(box);
    }
    return ends + begins;
  }

  static std::string opening(const Box& box) {
    const std::string id = box.exercise.empty() ? "" : " id=\"" + box_id(box.exercise) + "\"";
    return "<div class=\"" + box.name + "\"" + id + ">";
  }

  std::string line(std::size_t i) {
    if (const std::string number = announced_exercise(page_.lines[i]); !number.empty())
      exercise_ = number;
    if (i == 1 && page_.lines[i].empty() && page_.lines[0].starts_with("# ")) return top_html();
    if (i + 1 == page_.lines.size())
      if (const std::string links = neighbours_html(root_, page_); !links.empty())
        return html_block(links);
    const auto fence = std::find_if(fences_.begin(), fences_.end(), [i](const Fence& f) {
      return f.opening <= i && i <= f.closing;
    });
    if (fence != fences_.end()) return fenced_line(*fence, i);
    for (const Figure& figure : figures_) {
      if (i == figure.line) return figure_html(figure);
      if (figure.first <= i && i < figure.end) return "";  // it has gone into the figure
    }
    if (const std::string edges = box_edges(i); !edges.empty()) return html_block(edges);
    in_box_ = std::any_of(boxes_.begin(), boxes_.end(),
                          [i](const Box& box) { return box.first <= i && i < box.end; });
    return text_line(in_box_ ? unquoted(page_.lines[i]) : page_.lines[i]);
  }

  /// The empty line below the title: where from, where to, and what is on the page.
  std::string top_html() const {
    if (page_id(root_, page_.file) == "readme") return "";
    const std::string top = neighbours_html(root_, page_) + contents_html(root_, page_);
    return top.empty() ? "" : html_block(top);
  }

  std::string text_line(const std::string& text) const {
    if (text.starts_with("<!--")) return "";
    if (const Heading heading = heading_in(text); heading.level > 0) return heading_line(heading);
    if (text.starts_with("<details>") || text.starts_with("</details>") ||
        text.starts_with("<summary>"))
      return html_block(text);
    if (text.starts_with("> [!")) return alert_line(text);
    const std::string words = on_the_site(text);
    return with_formulas(with_links(words, links_in(words)));
  }

  std::string fenced_line(const Fence& fence, std::size_t i) const {
    if (fence.source == "output" || fence.source == "measured")
      if (const std::string table = number_table_html(content_of(page_, fence)); !table.empty())
        return i == fence.opening ? html_block(table) : "";
    std::string line = fence.quoted ? unquoted(page_.lines[i]) : page_.lines[i];
    if (fence.language != "math") return line;
    if (i == fence.opening) return "\\f[";
    return i == fence.closing ? "\\f]" : line;
  }

  /// The front page's sections are not the site's: no entries of a table of contents.
  std::string heading_line(const Heading& heading) const {
    const std::string id = page_id(root_, page_.file),
                      name = heading_id(root_, page_, heading.text);
    if (id == "readme" && heading.level > 1) {
      const std::string tag = "h" + std::to_string(heading.level);
      return html_block("<" + tag + " id=\"" + name + "\">" + inline_html(heading.text) + "</" +
                        tag + ">");
    }
    std::string title = heading.text;
    std::erase(title, '`');  // Doxygen would show its tags
    for (auto at = title.find("--"); at != std::string::npos; at = title.find("--", at + 3))
      title.insert(at, "\\");  // and make a dash of an option
    return std::string(heading.level, '#') + " " + title + " {#" +
           (heading.level == 1 ? id : name) + "}";
  }

  static std::string alert_line(const std::string& text) {
    static const std::map<std::string, std::string> commands{{"NOTE", "\\note"},
                                                             {"TIP", "\\remark"},
                                                             {"IMPORTANT", "\\attention"},
                                                             {"WARNING", "\\warning"},
                                                             {"CAUTION", "\\warning"}};
    const std::string kind = text.substr(4, text.find(']') - 4);
    const auto command = commands.find(kind);
    return command == commands.end() ? text : command->second;
  }

  std::string figure_html(const Figure& figure) const {
    const fs::path svg = fs::relative(page_.file.parent_path() / figure.picture, root_);
    const std::string& caption = figure.caption.empty() ? figure.alternative : figure.caption;
    return html_block(R"(<figure><div class="scroll" tabindex="0">)" + drawing_html(svg.string()) +
                      "</div><figcaption>" + inline_html(on_the_site(caption)) +
                      "</figcaption></figure>");
  }

  std::string with_links(const std::string& text, const std::vector<Link>& links) const {
    std::string result;
    std::size_t at = 0;
    for (const Link& link : links) {
      result += text.substr(at, link.begin - at) + linked(link);
      at = link.end;
    }
    return result + text.substr(at);
  }

  std::string linked(const Link& link) const {
    if (link.target.find("://") != std::string::npos || link.target.starts_with("mailto:"))
      return "[" + link.text + "](" + link.target + ")";
    const auto hash = link.target.find('#');
    const std::string path = link.target.substr(0, hash);
    const fs::path file = path.empty() ? page_.file : page_.file.parent_path() / path;
    if (is_public_header(root_, file)) {
      std::string name = link.text;
      std::erase(name, '`');  // Doxygen would show them
      return "[" + name + "](@ref " + path.substr(path.find("include/") + 8) + ")";
    }
    return "[" + link.text + "](" + address_of(root_, file) + place(file, hash, link.target) + ")";
  }

  /// "#…" in the page where a link leads, or nothing. The box of an exercise leads to that
  /// exercise.
  std::string place(const fs::path& file, std::size_t hash, const std::string& target) const {
    if (const fs::path folder = exercise_folder(root_, file);
        !folder.empty() && !exercise_.empty() && in_box_)
      return "#" + exercise_anchor(root_, folder, exercise_);
    if (hash == std::string::npos) return {};
    const fs::path page = fs::is_directory(file) ? file / "README.md" : file;
    return "#" + page_id(root_, page) + "-" + target.substr(hash + 1);
  }

  const fs::path& root_;
  const Page& page_;
  std::vector<Fence> fences_;
  std::vector<Figure> figures_;
  std::vector<Box> boxes_;
  std::string exercise_;  ///< the last that was announced
  bool in_box_ = false;
};

}  // namespace

std::string for_doxygen(const fs::path& root, const Page& page) {
  return Converter(root, page).convert();
}

}  // namespace tumble::book
