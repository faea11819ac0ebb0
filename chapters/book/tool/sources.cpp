#include "book/tool/sources.hpp"

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <sstream>
#include <stdexcept>

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
      if (content_of(page, fence) != wanted_content(places, fence))
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
    std::istringstream content(wanted_content(places, fence));
    for (std::string line; std::getline(content, line);) result.lines.push_back(line);
    next = fence.closing;
  }
  for (; next < page.lines.size(); ++next) result.lines.push_back(page.lines[next]);
  return result;
}

}  // namespace tumble::book
