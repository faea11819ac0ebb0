#include "project/bench/judge/program.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sched.h>
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "support/text_file.hpp"

namespace tumble::bench {

namespace {

using namespace std::chrono_literals;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Leaves this process the first of its cores, as many as that.
void restrict_to([[maybe_unused]] std::size_t cores) {
#ifdef __linux__
  cpu_set_t all, some;
  if (cores == 0 || sched_getaffinity(0, sizeof all, &all) != 0) return;
  CPU_ZERO(&some);
  for (std::size_t cpu = 0; cpu < CPU_SETSIZE && cores > 0; ++cpu)
    if (CPU_ISSET(cpu, &all)) {
      CPU_SET(cpu, &some);
      --cores;
    }
  sched_setaffinity(0, sizeof some, &some);
#endif
}

[[noreturn]] void become(const std::vector<char*>& command, const char* log, std::size_t cores) {
  restrict_to(cores);
  const int file = open(log, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(file, STDOUT_FILENO);
  dup2(file, STDERR_FILENO);
  execv(command[0], command.data());
  _exit(127);
}

}  // namespace

Program::Program(const std::vector<std::string>& command, const std::filesystem::path& log,
                 std::size_t cores)
    : start_(now()) {
  std::vector<char*> pointers;
  for (const std::string& word : command) pointers.push_back(const_cast<char*>(word.c_str()));
  pointers.push_back(nullptr);
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("cannot start " + command.at(0));
  if (pid_ == 0) become(pointers, log.c_str(), cores);
}

Program::~Program() {
  if (status_ >= 0) return;
  kill();
  wait();
}

void Program::note_end(int status, double processor) {
  status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  cost_ = {now() - start_, processor};
}

bool Program::ended() {
  if (status_ >= 0) return true;
  int status = 0;
  rusage used = {};
  if (wait4(pid_, &status, WNOHANG, &used) != pid_) return false;
  note_end(status, seconds_of(used.ru_utime) + seconds_of(used.ru_stime));
  return true;
}

void Program::kill() {
  if (status_ < 0) ::kill(pid_, SIGKILL);
}

int Program::wait() {
  while (!ended()) std::this_thread::sleep_for(5ms);
  return status_;
}

Cost run_to_end(const std::vector<std::string>& command, const std::filesystem::path& log,
                const std::vector<int>& statuses, std::size_t cores) {
  Program program(command, log, cores);
  const int status = program.wait();
  if (std::find(statuses.begin(), statuses.end(), status) == statuses.end()) {
    const std::string said = support::read_text(log);
    throw std::runtime_error(command[0] + " " + command[1] + " ends with status " +
                             std::to_string(status) + ": " +
                             said.substr(said.size() - std::min<std::size_t>(said.size(), 1000)));
  }
  return program.cost();
}

std::size_t cores_to_choose_from() {
#ifdef __linux__
  cpu_set_t all;
  if (sched_getaffinity(0, sizeof all, &all) == 0) return static_cast<std::size_t>(CPU_COUNT(&all));
#endif
  return 0;
}

bool adopt_orphans() {
#ifdef __linux__
  return prctl(PR_SET_CHILD_SUBREAPER, 1) == 0;
#else
  return false;
#endif
}

bool orphans_are_gone() {
  for (int i = 0; i < 100; ++i) {
    while (waitpid(-1, nullptr, WNOHANG) > 0) {
    }
    if (waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD) return true;
    std::this_thread::sleep_for(50ms);
  }
  return false;
}

}  // namespace tumble::bench
