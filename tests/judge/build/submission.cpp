#include "judge/build/submission.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>

#include "judge/sandbox/pipe.hpp"

namespace tumble::judge {

namespace {

/// The number of continuation bytes after this first byte of a UTF-8 sequence, or −1.
int continuation_bytes(unsigned char first) {
  if (first < 0x80) return 0;
  if (first >= 0xc2 && first < 0xe0) return 1;
  if (first >= 0xe0 && first < 0xf0) return 2;
  if (first >= 0xf0 && first < 0xf5) return 3;
  return -1;
}

/// The line of the first byte that is not UTF-8 or is NUL; 0 if there is none.
std::size_t line_that_is_no_text(const std::string& text) {
  std::size_t line = 1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto first = static_cast<unsigned char>(text[i]);
    const int more = continuation_bytes(first);
    if (more < 0 || first == 0) return line;
    for (int k = 0; k < more; ++k)
      if (++i >= text.size() || (static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) return line;
    if (first == '\n') ++line;
  }
  return 0;
}

}  // namespace

std::string read_submission(const std::filesystem::path& path) {
  const auto refuse = [&](const std::string& why) { throw Refused(path.string() + " " + why); };
  // O_NOFOLLOW: a link could lead to another's work. O_NONBLOCK: a pipe would wait for its writer.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (file.number() < 0 && errno == ENOENT) refuse("does not exist");
  if (file.number() < 0 && errno == ELOOP) refuse("is a symbolic link, not a file");
  if (file.number() < 0) refuse(std::string("cannot be read: ") + std::strerror(errno));
  struct stat status = {};
  if (::fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode))
    refuse("is not a regular file");
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > largest_submission)
    refuse("has " + std::to_string(size) + " bytes: more than the " +
           std::to_string(largest_submission) + " that a source file may have");
  std::string text;
  while (text.size() <= largest_submission && read_some(file.number(), text)) {
  }
  if (std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c); }))
    refuse("is empty");
  if (const std::size_t line = line_that_is_no_text(text); line > 0)
    refuse("is not UTF-8 text: see line " + std::to_string(line));
  return text;
}

}  // namespace tumble::judge
