#include "book/tool/fences.hpp"

#include <algorithm>

namespace tumble::book {

namespace {

/// Reads "<!-- snippet: path#region -->" into the fence that follows.
/// @return whether the line is such a comment
bool read_directive(const std::string& line, Fence& fence) {
  for (const std::string kind : {"snippet", "signature", "output", "measured"}) {
    const std::string start = "<!-- " + kind + ": ";
    if (!line.starts_with(start) || !line.ends_with(" -->")) continue;
    const std::string what = line.substr(start.size(), line.size() - start.size() - 4);
    const auto hash = what.find('#');
    fence.source = kind;
    fence.path = what.substr(0, hash);
    fence.region = hash == std::string::npos ? "" : what.substr(hash + 1);
    return !fence.path.empty() && !fence.region.empty();
  }
  return false;
}

/// What a line is by itself, wherever it is.
enum class LineKind {
  text,
  comment,
  fence,           ///< "```cpp" opens one, "```" opens or closes one
  indented_fence,  ///< which is a mistake everywhere
  tildes,          ///< "~~~", text within a fence and a mistake outside
};

struct PageLine {
  LineKind kind;
  bool quoted;
  std::string text;  ///< without the quotation's "> "
};

LineKind kind_of(const std::string& text) {
  if (text.starts_with("<!--")) return LineKind::comment;
  if (text.starts_with("```")) return LineKind::fence;
  if (trimmed(text).starts_with("```")) return LineKind::indented_fence;
  if (trimmed(text).starts_with("~~~")) return LineKind::tildes;
  return LineKind::text;
}

std::vector<PageLine> classified_lines(const Page& page) {
  std::vector<PageLine> lines;
  for (const std::string& line : page.lines) {
    const std::string text = unquoted(line);
    lines.push_back({kind_of(text), is_quoted(line), text});
  }
  return lines;
}

/// A comment is one line, and one above a fence says where the fence is from.
void require_valid_comment(const Page& page, const std::vector<PageLine>& lines, std::size_t line) {
  Fence fence;
  const bool announces = read_directive(lines[line].text, fence);
  const bool opens = line + 1 < lines.size() && lines[line + 1].kind == LineKind::fence;
  if (!lines[line].text.ends_with("-->")) fail(page, line, "a comment ends in its line");
  if (announces && !opens) fail(page, line, "this comment expects a ``` fence in the next line");
  if (opens && !announces)
    fail(page, line,
         "a fence is announced by snippet:, signature:, output: or measured: path#name");
}

/// The line that closes a fence: of the same quotation, or of none.
std::size_t closing_of(const Page& page, const std::vector<PageLine>& lines, std::size_t opening) {
  for (std::size_t i = opening + 1; i < lines.size(); ++i) {
    const PageLine& line = lines[i];
    if (line.text == "```" && line.quoted == lines[opening].quoted) return i;
    if (line.kind == LineKind::fence || line.kind == LineKind::indented_fence)
      fail(page, i,
           "a fence within the one of line " + std::to_string(opening + 1) +
               ", or blanks around its end");
  }
  fail(page, opening, "this fence is not closed");
}

/// @param lines those above the fence are valid
Fence fence_at(const Page& page, const std::vector<PageLine>& lines, std::size_t opening) {
  Fence fence;
  if (opening > 0) read_directive(lines[opening - 1].text, fence);
  fence.opening = opening;
  fence.closing = closing_of(page, lines, opening);
  fence.language = trimmed(lines[opening].text.substr(3));
  fence.quoted = lines[opening].quoted;
  return fence;
}

}  // namespace

std::vector<Fence> fences_of(const Page& page) {
  const std::vector<PageLine> lines = classified_lines(page);
  std::vector<Fence> fences;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    switch (lines[i].kind) {
      case LineKind::text:
        break;
      case LineKind::comment:
        require_valid_comment(page, lines, i);
        break;
      case LineKind::fence:
        fences.push_back(fence_at(page, lines, i));
        i = fences.back().closing;
        break;
      case LineKind::indented_fence:
      case LineKind::tildes:
        fail(page, i, "a fence begins with ``` in the first column");
    }
  }
  return fences;
}

std::string content_of(const Page& page, const Fence& fence) {
  std::string text;
  for (std::size_t i = fence.opening + 1; i < fence.closing; ++i)
    text += (fence.quoted ? unquoted(page.lines[i]) : page.lines[i]) + "\n";
  return text;
}

bool is_inside(const std::vector<Fence>& fences, std::size_t line) {
  return std::any_of(fences.begin(), fences.end(), [line](const Fence& fence) {
    return fence.opening <= line && line <= fence.closing;
  });
}

}  // namespace tumble::book
