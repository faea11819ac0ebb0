#include "book/tool/snippet.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <vector>

#include "tumble/core/require.hpp"

namespace tumble::book {

namespace {

using Lines = std::vector<std::string>;

Lines lines_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  require(static_cast<bool>(in), "there is no source file ", file.string());
  Lines lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Is `name` in the line as a word that is being defined: before (, {, =, ; or a base
/// class?
bool defines(const std::string& line, const std::string& name) {
  const auto at = line.find(name);
  if (at == std::string::npos || (at > 0 && is_word(line[at - 1]))) return false;
  const auto after = line.find_first_not_of(' ', at + name.size());
  if (at + name.size() < line.size() && is_word(line[at + name.size()])) return false;
  const bool type =
      line.find("struct ") < at || line.find("class ") < at || line.find("concept ") < at;
  if (after == std::string::npos) return type;
  const bool call_in_expression = line.find('=') < at || line.find("return") < at;
  return !call_in_expression &&
         std::string(type ? "{:=" : "({=").find(line[after]) != std::string::npos;
}

std::size_t indentation(const std::string& line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

bool is_comment(const std::string& line) { return line.compare(indentation(line), 2, "//") == 0; }

/// The first line of the definition: template and requires lines above belong to it.
std::size_t start_of(const Lines& lines, std::size_t at) {
  const std::size_t indent = indentation(lines[at]);
  while (at > 0) {
    const std::string& above = lines[at - 1];
    const bool belongs = !above.empty() && indentation(above) >= indent && !is_comment(above) &&
                         above.find_first_of(";}") == std::string::npos && !above.ends_with(":") &&
                         !above.starts_with("namespace") && !above.starts_with("#");
    if (!belongs) break;
    --at;
  }
  return at;
}

/// The last line: where all braces are closed again and the statement ends.
std::size_t end_of(const Lines& lines, std::size_t at) {
  int depth = 0;
  bool opened = false;
  for (; at < lines.size(); ++at) {
    for (const char c : lines[at]) {
      if (c == '{' || c == '(') ++depth;
      if (c == '}' || c == ')') --depth;
      opened = opened || c == '{';
    }
    const std::string& line = lines[at];
    if (depth == 0 && (line.ends_with(";") || (opened && line.find('}') != std::string::npos)))
      break;
  }
  return at;
}

std::size_t find_definition(const Lines& lines, const std::string& name, std::size_t from,
                            std::size_t to, std::size_t indent) {
  for (std::size_t i = from; i < to; ++i)
    if (indentation(lines[i]) == indent && !is_comment(lines[i]) && defines(lines[i], name))
      return i;
  return to;
}

/// All below the comment that opens the file, and below the empty lines after it.
std::string whole(const Lines& lines) {
  std::size_t i = 0;
  while (i < lines.size() && (lines[i].empty() || is_comment(lines[i]))) ++i;
  std::string text;
  for (; i < lines.size(); ++i) text += lines[i] + "\n";
  return text;
}

}  // namespace

std::string snippet(const std::filesystem::path& file, const std::string& name) {
  const Lines lines = lines_of(file);
  if (name == "*") return whole(lines);
  std::size_t from = 0, to = lines.size(), indent = 0;
  std::string last = name;
  if (const auto colons = name.find("::"); colons != std::string::npos) {
    const std::size_t outer = find_definition(lines, name.substr(0, colons), 0, to, 0);
    require(outer < to, file.string(), " does not define ", name.substr(0, colons));
    from = outer + 1;
    to = end_of(lines, outer);
    indent = 2;
    last = name.substr(colons + 2);
  }
  const std::size_t found = find_definition(lines, last, from, to, indent);
  require(found < to, file.string(), " does not define ", name);
  std::string text;
  const std::size_t end = end_of(lines, found);
  for (std::size_t i = start_of(lines, found); i <= end && i < lines.size(); ++i)
    text += lines[i].substr(std::min(indent, lines[i].size())) + "\n";
  return text;
}

std::string signature(const std::filesystem::path& file, const std::string& name) {
  const std::string text = snippet(file, name);
  int depth = 0;  // of parentheses: a default argument may have braces and an =
  std::size_t end = 0;
  for (; end < text.size(); ++end) {
    if (text[end] == '(') ++depth;
    if (text[end] == ')') --depth;
    if (depth == 0 && (text[end] == '{' || text.compare(end, 3, " = ") == 0)) break;
  }
  std::string head = text.substr(0, end);
  head.erase(head.find_last_not_of(" \n;") + 1);
  return head + ";\n";
}

}  // namespace tumble::book
