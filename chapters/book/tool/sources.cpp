#include "book/tool/sources.hpp"

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "book/tool/snippet.hpp"

namespace tumble::book {

namespace {

/// One word for the shell, whatever it contains.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

/// Standard output of a command.
std::string output_of(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) throw std::runtime_error("cannot run " + command);
  std::string text;
  std::array<char, 4096> buffer{};
  while (const std::size_t got = std::fread(buffer.data(), 1, buffer.size(), pipe))
    text.append(buffer.data(), got);
  if (const int status = pclose(pipe); status != 0) {
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    throw std::runtime_error(command + " fails with status " + std::to_string(code));
  }
  return text;
}

bool is_number(const std::string& word) {
  char* end = nullptr;
  std::strtod(word.c_str(), &end);
  return end == word.c_str() + word.size();
}

/// A table without its times, its multiples (1.9 ×) and the widths of its columns: what two
/// measurements have in common, every other number included.
std::string words_of(const std::string& table) {
  std::istringstream in(table);
  std::vector<std::string> words;
  for (std::string word; in >> word;) {
    const bool measure = word == "ns" || word == "µs" || word == "ms" || word == "s" || word == "×";
    if (measure && !words.empty() && is_number(words.back()))
      words.back() = "#";
    else if (!word.starts_with("─"))
      words.push_back(word);
  }
  std::string text;
  for (const std::string& word : words) text += word + " ";
  return text;
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
  return output_of(quoted(program.string()) + " --only " + quoted(fence.region));
}

std::vector<std::string> stale_fences(const Places& places, const Page& page) {
  std::vector<std::string> stale;
  for (const Fence& fence : fences_of(page)) {
    if (fence.source.empty()) continue;
    const std::string place = page.file.string() + ":" + std::to_string(fence.opening + 1) + ": ";
    try {
      if (!is_fresh(content_of(page, fence), wanted_content(places, fence), fence))
        stale.push_back(place + fence.path + "#" + fence.region +
                        " has changed; ./tumble book --write updates the page");
    } catch (const std::exception& e) {
      stale.push_back(place + e.what());
    }
  }
  return stale;
}

namespace {

/// wanted_content(), with the fence's place in what goes wrong.
std::string wanted_at(const Places& places, const Page& page, const Fence& fence) {
  try {
    return wanted_content(places, fence);
  } catch (const std::exception& error) {
    fail(page, fence.opening, error.what());
  }
}

}  // namespace

Page refreshed(const Places& places, const Page& page) {
  Page result{page.file, {}};
  std::size_t next = 0;
  for (const Fence& fence : fences_of(page)) {
    if (fence.source.empty()) continue;
    for (; next <= fence.opening; ++next) result.lines.push_back(page.lines[next]);
    const std::string shown = content_of(page, fence), wanted = wanted_at(places, page, fence);
    std::istringstream content(is_fresh(shown, wanted, fence) ? shown : wanted);
    for (std::string line; std::getline(content, line);)
      result.lines.push_back(!fence.quoted ? line : line.empty() ? ">" : "> " + line);
    next = fence.closing;
  }
  for (; next < page.lines.size(); ++next) result.lines.push_back(page.lines[next]);
  return result;
}

}  // namespace tumble::book
