#include "judge/build/submission.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "judge/build/source_text.hpp"
#include "judge/sandbox/pipe.hpp"
#include "support/entry.hpp"

namespace tumble::judge {

void require_working_machine(const std::filesystem::path& path, int error) {
  constexpr std::array of_the_machine = {EMFILE,  ENFILE,    ENOMEM, EIO,  ESTALE,
                                         ENOBUFS, ETIMEDOUT, EACCES, EPERM};
  if (std::find(of_the_machine.begin(), of_the_machine.end(), error) != of_the_machine.end())
    throw std::runtime_error("cannot read " + path.string() + ": " + std::strerror(error));
}

DecodedText read_decoded_submission(const std::filesystem::path& path) {
  const auto refuse = [&](const std::string& why) { throw Refused(path.string() + " " + why); };
  // O_NOFOLLOW: a link, or a folder that is one, could lead to another's work.
  // O_NONBLOCK: a pipe would wait for its writer.
  const Descriptor folder(
      ::open(path.parent_path().c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  std::error_code gone;
  if (folder.number() < 0) require_working_machine(path, errno);
  if (folder.number() < 0 && std::filesystem::is_symlink(path.parent_path(), gone))
    refuse("is in a folder that is a symbolic link");
  const Descriptor file(::openat(folder.number(), path.filename().c_str(),
                                 O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  const int error = errno;
  if (file.number() < 0) require_working_machine(path, error);
  if (file.number() < 0 && !support::is_there(path)) refuse("does not exist");
  if (file.number() < 0 && error == ELOOP) refuse("is a symbolic link, not a file");
  if (file.number() < 0) refuse(std::string("cannot be read: ") + std::strerror(error));
  struct stat status = {};
  if (::fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode))
    refuse("is not a regular file");
  const auto size = static_cast<std::size_t>(status.st_size);
  if (const std::string why = too_large(size); !why.empty()) refuse(why);
  std::string text;
  while (text.size() <= largest_submission && read_some(file.number(), text)) {
  }
  if (text.size() < size)
    throw std::runtime_error("cannot read all of " + path.string() + ": a disk that fails?");
  DecodedText result = decoded(text);
  if (const std::string why = reason_to_refuse(result.text); !why.empty()) refuse(why);
  return result;
}

std::string read_submission(const std::filesystem::path& path) {
  return read_decoded_submission(path).text;
}

}  // namespace tumble::judge
