#include "judge/class/process_pool.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cerrno>
#include <cstring>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "judge/sandbox/pipe.hpp"

namespace tumble::judge {

namespace {

/// A child and the pipe through which it ticks.
struct Child {
  std::size_t number;
  pid_t pid;
  Descriptor ticks;
};

using Task = std::function<void(std::size_t, const std::function<void()>&)>;

[[noreturn]] void run_job(const Task& job, std::size_t number, int ticks) {
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // nothing goes on when the parent is killed
  if (getppid() == 1) _exit(1);
#endif
  int status = 1;
  try {
    job(number, [ticks] {
      const char one = 1;
      [[maybe_unused]] const ssize_t written = write(ticks, &one, 1);
    });
    status = 0;
  } catch (const std::exception& error) {
    std::cerr << "tumble: " << error.what() << '\n';
  }
  _exit(status);  // what else is open belongs to the parent
}

Child start(const Task& job, std::size_t number) {
  Pipe pipe = make_pipe();
  std::cout.flush();
  const pid_t pid = fork();
  if (pid < 0) throw std::runtime_error(std::string("cannot fork: ") + std::strerror(errno));
  if (pid == 0) run_job(job, number, pipe.write.number());
  return {number, pid, std::move(pipe.read)};
}

bool has_succeeded(pid_t pid) {
  int status = 0;
  while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Waits until a child ticks or ends.
void wait_for_news(const std::vector<Child>& running) {
  std::vector<pollfd> files;
  files.reserve(running.size());
  for (const Child& child : running) files.push_back({child.ticks.number(), POLLIN, 0});
  poll(files.data(), static_cast<nfds_t>(files.size()), -1);
}

/// Whether there is something to read, or the end.
bool has_news(const Child& child) {
  pollfd file{child.ticks.number(), POLLIN, 0};
  return poll(&file, 1, 0) > 0;
}

}  // namespace

void run_in_processes(std::size_t count, std::size_t at_once, const Task& job,
                      const std::function<void()>& ticked,
                      const std::function<void(FinishedJob)>& finished) {
  std::vector<Child> running;
  for (std::size_t next = 0; next < count || !running.empty();) {
    while (next < count && running.size() < at_once) running.push_back(start(job, next++));
    wait_for_news(running);
    for (std::size_t i = running.size(); i-- > 0;) {
      if (!has_news(running[i])) continue;
      std::string ticks;
      const bool open = read_some(running[i].ticks.number(), ticks);
      for (std::size_t k = 0; k < ticks.size(); ++k) ticked();
      if (open) continue;
      const FinishedJob ended{running[i].number, has_succeeded(running[i].pid)};
      running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
      finished(ended);
    }
  }
}

}  // namespace tumble::judge
