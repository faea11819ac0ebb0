#include "judge/build/submission.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "judge/sandbox/pipe.hpp"

namespace tumble::judge {

namespace {

/// The length of the UTF-8 character at `at`, 0 if there is none (Unicode 15, table 3-7: no
/// overlong forms, no surrogates, nothing above U+10FFFF).
std::size_t character_length(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0u;
  };
  const auto continues = [&](std::size_t i) { return (byte(i) & 0xc0) == 0x80; };
  const unsigned first = byte(0), second = byte(1);
  if (first > 0 && first < 0x80) return 1;
  if (first >= 0xc2 && first < 0xe0) return continues(1) ? 2 : 0;
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool no_character = (first == 0xed && second >= 0xa0) || (first == 0xf4 && second >= 0x90);
  if (overlong || no_character || !continues(1) || !continues(2)) return 0;
  if (first >= 0xe0 && first < 0xf0) return 3;
  return first >= 0xf0 && first < 0xf5 && continues(3) ? 4 : 0;
}

/// The line of the first byte that is not UTF-8 or is NUL; 0 if there is none.
std::size_t line_that_is_no_text(const std::string& text) {
  std::size_t line = 1;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text, i);
    if (length == 0) return line;
    if (text[i] == '\n') ++line;
    i += length;
  }
  return 0;
}

/// A file that this machine cannot open is not one that the student has not handed in.
void require_working_machine(const std::filesystem::path& path, int error) {
  constexpr std::array of_the_machine = {EMFILE, ENFILE, ENOMEM, EIO, ESTALE};
  if (std::find(of_the_machine.begin(), of_the_machine.end(), error) != of_the_machine.end())
    throw std::runtime_error("cannot read " + path.string() + ": " + std::strerror(error));
}

}  // namespace

std::string read_submission(const std::filesystem::path& path) {
  const auto refuse = [&](const std::string& why) { throw Refused(path.string() + " " + why); };
  // O_NOFOLLOW: a link, or a folder that is one, could lead to another's work.
  // O_NONBLOCK: a pipe would wait for its writer.
  const Descriptor folder(
      ::open(path.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (folder.number() < 0) require_working_machine(path, errno);
  if (folder.number() < 0 && std::filesystem::is_symlink(path.parent_path()))
    refuse("is in a folder that is a symbolic link");
  const Descriptor file(::openat(folder.number(), path.filename().c_str(),
                                 O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  const int error = errno;
  if (file.number() < 0) require_working_machine(path, error);
  if (file.number() < 0 && !std::filesystem::exists(std::filesystem::symlink_status(path)))
    refuse("does not exist");
  if (file.number() < 0 && error == ELOOP) refuse("is a symbolic link, not a file");
  if (file.number() < 0) refuse(std::string("cannot be read: ") + std::strerror(error));
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
  if (text.size() < size)
    throw std::runtime_error("cannot read all of " + path.string() + ": a disk that fails?");
  if (std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isspace(c); }))
    refuse("is empty");
  if (const std::size_t line = line_that_is_no_text(text); line > 0)
    refuse("is not UTF-8 text: see line " + std::to_string(line));
  return text;
}

}  // namespace tumble::judge
