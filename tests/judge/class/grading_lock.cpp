#include "judge/class/grading_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <string>
#include <thread>

#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

/// What has killed a grading has its children still dying.
bool is_taken(int file, GradingLock::With with) {
  const int kind = with == GradingLock::With::nobody ? LOCK_EX : LOCK_SH;
  for (int i = 0; i < 20; ++i) {
    if (::flock(file, kind | LOCK_NB) == 0 || errno != EWOULDBLOCK) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return true;
}

/// Who holds a lock alone has written its number there.
std::string holder_of(int file) {
  std::string number;
  read_some(file, number, 20);
  return number.empty() ? "" : ", process " + number;
}

}  // namespace

GradingLock::GradingLock(const std::filesystem::path& file, const std::string& where, With with)
    : file_(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644)) {
  if (file_.number() < 0)
    throw std::runtime_error("cannot write " + file.string() + ": " + std::strerror(errno));
  if (is_taken(file_.number(), with))
    require(false, "another grading is at work in ", where, holder_of(file_.number()),
            ": wait for its end, or take another folder with --out");
  const std::string self = with == With::nobody ? std::to_string(::getpid()) : "";
  // Only who is told of it reads this.
  [[maybe_unused]] const bool written =
      ::ftruncate(file_.number(), 0) == 0 &&
      ::write(file_.number(), self.data(), self.size()) == static_cast<ssize_t>(self.size());
}

}  // namespace tumble::judge
