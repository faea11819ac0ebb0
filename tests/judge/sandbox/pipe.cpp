#include "judge/sandbox/pipe.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "judge/sandbox/platform.hpp"

namespace tumble::judge {

Clock::time_point after(double seconds) {
  return Clock::now() +
         std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  if (this != &other) {
    reset();
    number_ = other.release();
  }
  return *this;
}

int Descriptor::release() { return std::exchange(number_, -1); }

void Descriptor::reset() {
  if (number_ >= 0) ::close(release());
}

Pipe make_pipe() {
  int ends[2];
  if (!platform::make_pipe(ends))
    throw std::runtime_error(std::string("no pipe: ") + std::strerror(errno));
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

namespace {

/// poll() until something is ready or the deadline has come.
void poll_until(pollfd* files, nfds_t count, Clock::time_point deadline) {
  int ready;
  do {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    ready = ::poll(files, count, static_cast<int>(std::clamp<long long>(left, 0, 1 << 30)));
  } while (ready < 0 && errno == EINTR);
}

}  // namespace

Ready wait_readable(int first, int second, Clock::time_point deadline) {
  pollfd files[] = {{first, POLLIN, 0}, {second, POLLIN, 0}};
  poll_until(files, 2, deadline);
  return {files[0].revents != 0, files[1].revents != 0};
}

bool write_all(int descriptor, const std::string& bytes, Clock::time_point deadline) {
  ::fcntl(descriptor, F_SETFL, O_NONBLOCK);
  for (std::size_t sent = 0; sent < bytes.size();) {
    const ssize_t written = ::write(descriptor, bytes.data() + sent, bytes.size() - sent);
    if (written > 0) {
      sent += static_cast<std::size_t>(written);
    } else if (errno == EAGAIN && Clock::now() < deadline) {
      pollfd file = {descriptor, POLLOUT, 0};
      poll_until(&file, 1, deadline);
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

bool read_some(int descriptor, std::string& to, std::size_t most) {
  const std::size_t before = to.size();
  to.resize(before + most);
  ssize_t got;
  do got = ::read(descriptor, to.data() + before, most);
  while (got < 0 && errno == EINTR);
  to.resize(before + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  return got > 0;
}

}  // namespace tumble::judge
