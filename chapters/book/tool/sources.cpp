#include "book/tool/sources.hpp"

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "book/tool/snippet.hpp"

namespace tumble::book {

namespace {

/// Standard output of a command.
std::string output_of(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) throw std::runtime_error("cannot run " + command);
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), pipe))
    text.append(buffer.data(), got);
  if (const int status = pclose(pipe); status != 0)
    throw std::runtime_error(command + " fails with status " + std::to_string(WEXITSTATUS(status)));
  return text;
}

bool is_one_of(char c, std::string_view set) { return set.find(c) != std::string_view::npos; }

/// The words of a table, without its numbers, their units and the widths of its columns: what two
/// measurements have in common.
std::string words_of(const std::string& table) {
  std::string words;
  std::istringstream in(table);
  bool after_number = false;
  for (std::string word; in >> word;) {
    const bool is_unit = word == "ns" || word == "µs" || word == "ms" || word == "s";
    const bool is_number = is_one_of(word[0], "0123456789");
    const bool is_rule = word.starts_with("─");
    if (!is_number && !is_rule && !(is_unit && after_number)) words += word + " ";
    after_number = is_number;
  }
  return words;
}

/// Whether the fence says what it should: letter for letter, or but for times that were measured.
bool is_fresh(const std::string& shown, const std::string& wanted, const Fence& fence) {
  if (fence.source == "measured") return words_of(shown) == words_of(wanted);
  return shown == wanted;
}

}  // namespace

std::string wanted_content(const Places& places, const Fence& fence) {
  if (fence.source == "snippet") return snippet(places.root / fence.path, fence.region);
  if (fence.source == "signature") return signature(places.root / fence.path, fence.region);
  const fs::path program = places.programs / fence.path;
  return output_of("'" + program.string() + "' --only '" + fence.region + "'");
}

std::vector<std::string> stale_fences(const Places& places, const Page& page) {
  std::vector<std::string> stale;
  for (const Fence& fence : fences_of(page)) {
    if (fence.source.empty()) continue;
    const std::string place = page.file.string() + ":" + std::to_string(fence.opening + 1) + ": ";
    try {
      if (!is_fresh(content_of(page, fence), wanted_content(places, fence), fence))
        stale.push_back(place + fence.path + "#" + fence.region +
                        " has changed; ./tumble book --write takes it over");
    } catch (const std::exception& e) {
      stale.push_back(place + e.what());
    }
  }
  return stale;
}

Page refreshed(const Places& places, const Page& page) {
  Page result{page.file, {}};
  std::size_t next = 0;
  for (const Fence& fence : fences_of(page)) {
    if (fence.source.empty()) continue;
    for (; next <= fence.opening; ++next) result.lines.push_back(page.lines[next]);
    const std::string shown = content_of(page, fence), wanted = wanted_content(places, fence);
    std::istringstream content(is_fresh(shown, wanted, fence) ? shown : wanted);
    for (std::string line; std::getline(content, line);) result.lines.push_back(line);
    next = fence.closing;
  }
  for (; next < page.lines.size(); ++next) result.lines.push_back(page.lines[next]);
  return result;
}

}  // namespace tumble::book
