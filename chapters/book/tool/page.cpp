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
