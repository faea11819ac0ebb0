#include "book/tool/site.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>

#include "book/tool/boxes.hpp"
#include "book/tool/figures.hpp"
#include "book/tool/links.hpp"
#include "book/tool/maths.hpp"
#include "support/svg.hpp"

namespace tumble::book {

namespace {

const std::string marker_start = "<div data-figure=\"", marker_end = "\"></div>";

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw PageError(file.string() + ":1: cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

/// One block of HTML in one line: Doxygen passes it on as it is.
std::string html(const std::string& text) { return "\\htmlonly[block] " + text + " \\endhtmlonly"; }

/// Doxygen shows the backticks in the text of a reference.
std::string plain(std::string text) {
  std::erase(text, '`');
  return text;
}

/// `code` in HTML; the text has no other mark-up.
std::string with_code(const std::string& text) {
  std::string result;
  bool inside = false;
  for (const char c : support::svg_text(text)) {
    if (c != '`') {
      result += c;
      continue;
    }
    result += inside ? "</code>" : "<code>";
    inside = !inside;
  }
  return result;
}

/// The caption keeps its formulas: the page's script sets what stands between \( and \).
std::string caption_html(const std::string& caption) {
  std::string result;
  std::size_t at = 0;
  for (const InlineFormula& formula : formulas_in(caption)) {
    result += with_code(caption.substr(at, formula.begin - at)) + "\\(" +
              support::svg_text(formula.tex) + "\\)";
    at = formula.end;
  }
  return result + with_code(caption.substr(at));
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
      if (i + 1 == box.first) begins = "<div class=\"" + box.name + "\">";
    }
    return ends + begins;
  }

  std::string line(std::size_t i) {
    const auto fence = std::find_if(fences_.begin(), fences_.end(), [i](const Fence& f) {
      return f.opening <= i && i <= f.closing;
    });
    if (fence != fences_.end()) return fenced_line(*fence, i);
    for (const Figure& figure : figures_) {
      if (i == figure.line) return figure_html(figure);
      if (figure.first <= i && i < figure.end) return "";  // it has gone into the figure
    }
    if (const std::string edges = box_edges(i); !edges.empty()) return html(edges);
    for (const Box& box : boxes_) {
      if (box.first <= i && i < box.end) return text_line(unquoted(page_.lines[i]));
    }
    return text_line(page_.lines[i]);
  }

  std::string text_line(const std::string& text) const {
    if (text.starts_with("<!--")) return "";
    if (const Heading heading = heading_in(text); heading.level > 0) return heading_line(heading);
    if (text.starts_with("<details>") || text.starts_with("</details>") ||
        text.starts_with("<summary>"))
      return html(text);
    if (text.starts_with("> [!")) return alert_line(text);
    return with_formulas(with_links(text, links_in(text)));
  }

  std::string fenced_line(const Fence& fence, std::size_t i) const {
    std::string line = fence.quoted ? unquoted(page_.lines[i]) : page_.lines[i];
    if (fence.language != "math") return line;
    if (i == fence.opening) return "\\f[";
    return i == fence.closing ? "\\f]" : line;
  }

  std::string heading_line(const Heading& heading) const {
    const std::string id = page_id(root_, page_.file);
    const std::string name = heading.level == 1 ? id : id + "-" + anchor_of(heading.text);
    return std::string(heading.level, '#') + " " + heading.text + " {#" + name + "}";
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

  /// Doxygen's scanner cannot take a drawing of 100 kB: its place is marked, and filled afterwards.
  std::string figure_html(const Figure& figure) const {
    const fs::path svg = fs::relative(page_.file.parent_path() / figure.picture, root_);
    const std::string& caption = figure.caption.empty() ? figure.alternative : figure.caption;
    return html("<figure>" + marker_start + svg.string() + marker_end + "<figcaption>" +
                caption_html(caption) + "</figcaption></figure>");
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
    if (link.target.find("://") != std::string::npos)
      return "[" + link.text + "](" + link.target + ")";
    const auto hash = link.target.find('#');
    const std::string path = link.target.substr(0, hash);
    const fs::path file = path.empty() ? page_.file : page_.file.parent_path() / path;
    const fs::path page = fs::is_directory(file) ? file / "README.md" : file;
    if (is_in_the_site(page)) {
      const std::string anchor =
          hash == std::string::npos ? "" : "-" + link.target.substr(hash + 1);
      return "[" + plain(link.text) + "](@ref " + page_id(root_, page) + anchor + ")";
    }
    if (page.extension() == ".hpp" && link.target.find("include/") != std::string::npos)
      return "[" + link.text + "](@ref " + link.target.substr(link.target.find("include/") + 8) +
             ")";
    return link.text;  // a source file that the site does not hold
  }

  bool is_in_the_site(const fs::path& file) const {
    const fs::path relative = fs::relative(file, root_);
    return relative == "README.md" ||
           (file.extension() == ".md" && *relative.begin() == "chapters");
  }

  static std::string with_formulas(const std::string& text) {
    std::string result;
    std::size_t at = 0;
    for (const InlineFormula& formula : formulas_in(text)) {
      result += text.substr(at, formula.begin - at) + "\\f$" + formula.tex + "\\f$";
      at = formula.end;
    }
    return result + text.substr(at);
  }

  const fs::path& root_;
  const Page& page_;
  std::vector<Fence> fences_;
  std::vector<Figure> figures_;
  std::vector<Box> boxes_;
};

}  // namespace

std::string page_id(const fs::path& root, const fs::path& file) {
  std::string id = fs::relative(file.parent_path(), root).string();
  if (id == ".") return "readme";
  if (file.filename() != "README.md") id += "-" + file.stem().string();
  std::replace(id.begin(), id.end(), '/', '-');
  return id;
}

std::string for_doxygen(const fs::path& root, const Page& page) {
  return Converter(root, page).convert();
}

namespace {

void fill_in_page(const fs::path& root, const fs::path& html_file) {
  const std::string text = text_of(html_file);
  std::string filled;
  std::size_t at = 0;
  for (auto start = text.find(marker_start); start != std::string::npos;
       start = text.find(marker_start, at)) {
    const std::size_t name = start + marker_start.size();
    const std::size_t end = text.find(marker_end, name);
    filled += text.substr(at, start - at) + text_of(root / text.substr(name, end - name));
    at = end + marker_end.size();
  }
  if (at > 0) std::ofstream(html_file) << filled << text.substr(at);
}

}  // namespace

void fill_in_figures(const fs::path& root, const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".html") fill_in_page(root, entry.path());
}

}  // namespace tumble::book
