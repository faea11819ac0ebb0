#include "judge/sandbox/process_pool.hpp"

#include <poll.h>
#include <signal.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <vector>

#include "judge/sandbox/pipe.hpp"
#include "judge/sandbox/platform.hpp"

namespace tumble::judge {

namespace {

/// A child and the pipes through which it sends, and says why it failed.
struct Child {
  std::size_t number;
  pid_t pid;
  Descriptor sent, failure;
};

using Task = std::function<void(std::size_t, const SendBytes&)>;

void write_whole(int to, const std::string& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = ::write(to, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) _exit(1);  // nobody is there to whom it could matter
    done += static_cast<std::size_t>(written);
  }
}

[[noreturn]] void run_job(const Task& job, std::size_t number, int sent, int failure) {
  platform::die_with_parent();  // nothing goes on when the parent is killed
  if (getppid() == 1) _exit(1);
  int status = 1;
  try {
    job(number, [sent](const std::string& bytes) { write_whole(sent, bytes); });
    status = 0;
  } catch (const std::exception& error) {
    constexpr std::size_t most = 4000;  // a pipe holds more: nobody reads before the end
    write_whole(failure, std::string(error.what()).substr(0, most));
  }
  std::cout.flush();
  _exit(status);  // what else is open belongs to the parent
}

Child start(const Task& job, std::size_t number, std::size_t memory_bytes) {
  Pipe sent = make_pipe(), failure = make_pipe();
  std::cout.flush();
  const pid_t pid = fork();
  if (pid < 0) throw std::runtime_error(std::string("cannot fork: ") + strerror(errno));
  if (pid == 0) {
    platform::limit_own_memory(memory_bytes);
    run_job(job, number, sent.write.number(), failure.write.number());
  }
  return {number, pid, std::move(sent.read), std::move(failure.read)};
}

/// Why a child that has closed its pipes did not succeed.
std::string failure_of(Child& child) {
  std::string thrown;
  while (read_some(child.failure.number(), thrown)) {
  }
  int status = 0;
  while (waitpid(child.pid, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status))
    return "signal " + std::to_string(WTERMSIG(status)) + ", " + strsignal(WTERMSIG(status));
  if (WEXITSTATUS(status) == 0) return {};
  return thrown.empty() ? "status " + std::to_string(WEXITSTATUS(status)) : thrown;
}

/// Waits until a child sends or ends.
void wait_for_news(const std::vector<Child>& running) {
  std::vector<pollfd> files;
  files.reserve(running.size());
  for (const Child& child : running) files.push_back({child.sent.number(), POLLIN, 0});
  poll(files.data(), static_cast<nfds_t>(files.size()), -1);
}

/// Whether there is something to read, or the end.
bool has_news(const Child& child) {
  pollfd file{child.sent.number(), POLLIN, 0};
  return poll(&file, 1, 0) > 0;
}

}  // namespace

void run_in_processes(std::size_t count, const ProcessPool& pool, const Task& job) {
  std::vector<Child> running;
  for (std::size_t next = 0; next < count || !running.empty();) {
    for (; next < count && running.size() < pool.at_once; ++next)
      running.push_back(start(job, next, pool.memory_bytes));
    wait_for_news(running);
    for (std::size_t i = running.size(); i-- > 0;) {
      if (!has_news(running[i])) continue;
      std::string bytes;
      const bool open = read_some(running[i].sent.number(), bytes);
      if (!bytes.empty()) pool.received(running[i].number, bytes);
      if (open) continue;
      const FinishedJob ended{running[i].number, failure_of(running[i])};
      running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
      pool.finished(ended);
    }
  }
}

}  // namespace tumble::judge
