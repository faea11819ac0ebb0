#include "judge/class/grading_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <string>
#include <thread>

#include "judge/class/file_names.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

/// What has killed a grading has its children still dying.
/// @return 0, or why there is no lock: EWOULDBLOCK if somebody else has it
int error_of_locking(int file, GradingLock::With with) {
  const int kind = with == GradingLock::With::nobody ? LOCK_EX : LOCK_SH;
  for (int i = 0; i < 20; ++i) {
    if (::flock(file, kind | LOCK_NB) == 0) return 0;
    if (errno != EWOULDBLOCK && errno != EINTR) return errno;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return EWOULDBLOCK;
}

/// "process 4711 on lab3": the folder may be on a disk that several machines share.
std::string this_process() {
  char host[65] = {};
  ::gethostname(host, sizeof host - 1);
  return "process " + std::to_string(::getpid()) + " on " + host;
}

/// Who holds a lock alone has said so there.
std::string holder_of(int file) {
  constexpr std::size_t most = 100;
  std::string holder;
  read_some(file, holder, most);
  return holder.empty() ? "" : ", " + escaped(holder);
}

}  // namespace

GradingLock::GradingLock(const std::filesystem::path& file, const std::string& where, With with)
    : file_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644)) {
  if (file_.number() < 0)
    throw std::runtime_error("cannot write " + file.string() + ": " + std::strerror(errno));
  const int error = error_of_locking(file_.number(), with);
  if (error == EWOULDBLOCK)
    require(false, "another grading is at work in ", where, holder_of(file_.number()),
            ": wait for its end, or take another folder with --out");
  if (error != 0)
    std::cerr << "tumble: the file system of " << where << " has no locks (" << std::strerror(error)
              << "): start no other grading in this folder before this one has ended\n";
  const std::string self = with == With::nobody ? this_process() : "";
  // Only who is told of it reads this.
  [[maybe_unused]] const bool written =
      ::ftruncate(file_.number(), 0) == 0 &&
      ::write(file_.number(), self.data(), self.size()) == static_cast<ssize_t>(self.size());
}

}  // namespace tumble::judge
