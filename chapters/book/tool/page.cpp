#include "book/tool/page.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace tumble::book {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

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

}  // namespace

std::string at(const Page& page, std::size_t line) {
  return page.file.string() + ":" + std::to_string(line + 1) + ": ";
}

void fail(const Page& page, std::size_t line, const std::string& what) {
  throw PageError(at(page, line) + what);
}

Page read_page(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw PageError(file.string() + ":1: cannot be read");
  Page page{file, {}};
  for (std::string line; std::getline(in, line);) page.lines.push_back(line);
  if (in.bad()) throw PageError(file.string() + ":1: cannot be read to its end");
  return page;
}

void write_page(const Page& page) {
  const fs::path fresh = page.file.string() + ".new";
  std::ofstream out(fresh, std::ios::binary);
  for (const std::string& line : page.lines) out << line << "\n";
  out.close();
  if (!out) {
    fs::remove(fresh);
    throw PageError(page.file.string() + ":1: cannot be written");
  }
  fs::rename(fresh, page.file);
}

Page page_of(const fs::path& file, const std::string& text) {
  Page page{file, {}};
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) page.lines.push_back(line);
  return page;
}

bool is_quoted(const std::string& line) { return line == ">" || line.starts_with("> "); }

std::string unquoted(const std::string& line) {
  return is_quoted(line) ? line.substr(std::min<std::size_t>(2, line.size())) : line;
}

namespace {

/// The line that closes a fence: of the same quotation, or of none.
/// @param lines of the page, unquoted
std::size_t closing_of(const Page& page, const std::vector<std::string>& lines,
                       const Fence& fence) {
  for (std::size_t i = fence.opening + 1; i < lines.size(); ++i) {
    if (lines[i] == "```" && is_quoted(page.lines[i]) == fence.quoted) return i;
    if (trimmed(lines[i]).starts_with("```"))
      fail(page, i,
           "a fence within the one of line " + std::to_string(fence.opening + 1) +
               ", or blanks around its end");
  }
  fail(page, fence.opening, "this fence is not closed");
}

}  // namespace

std::vector<Fence> fences_of(const Page& page) {
  std::vector<std::string> lines;
  for (const std::string& line : page.lines) lines.push_back(unquoted(line));
  std::vector<Fence> fences;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Fence fence;
    const bool announced = read_directive(lines[i], fence);
    const bool comment = lines[i].starts_with("<!--");
    if (comment) ++i;
    const bool opens = i < lines.size() && lines[i].starts_with("```");
    if (comment && !lines[i - 1].ends_with("-->")) fail(page, i - 1, "a comment ends in its line");
    if (announced && !opens) fail(page, i - 1, "this comment expects a ``` fence in the next line");
    if (comment && !opens) --i;  // an announcement may follow
    if (comment && opens && !announced)
      fail(page, i - 1,
           "a fence is announced by snippet:, signature:, output: or measured: path#name");
    const bool elsewhere =
        i < lines.size() && !opens && lines[i].find_first_not_of(" >-*\t") != std::string::npos &&
        (trimmed(lines[i]).starts_with("```") || trimmed(lines[i]).starts_with("~~~"));
    if (elsewhere) fail(page, i, "a fence begins with ``` in the first column");
    if (!opens) continue;
    fence.opening = i;
    fence.quoted = is_quoted(page.lines[i]);
    fence.language = trimmed(lines[i].substr(3));
    i = fence.closing = closing_of(page, lines, fence);
    fences.push_back(fence);
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

std::string without_code_spans(const std::string& line) {
  std::string text = line;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '$' && i + 1 < line.size() && line[i + 1] == '`') {  // a formula, not code
      const auto end = line.find("`$", i + 2);
      if (end != std::string::npos) i = end + 1;
      continue;
    }
    if (line[i] != '`') continue;
    const auto end = line.find('`', i + 1);
    if (end == std::string::npos) break;
    text.replace(i, end - i + 1, end - i + 1, ' ');
    i = end;
  }
  return text;
}

}  // namespace tumble::book
