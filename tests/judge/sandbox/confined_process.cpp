#include "judge/sandbox/confined_process.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "judge/sandbox/open_files.hpp"
#include "judge/sandbox/pipe.hpp"
#include "judge/sandbox/platform.hpp"
#include "judge/sandbox/system_calls.hpp"

namespace tumble::judge {

namespace {

/// What a child does before it becomes the program; its number tells the parent which step failed.
enum class Step : int { rules, files, folder, limits, user, calls, start };

constexpr std::array<const char*, 7> step_names = {
    "file rules (Landlock)", "its open files",         "its folder", "limits (setrlimit)",
    "another user",          "system calls (seccomp)", "the program"};

struct Failure {
  Step step;
  int error;
};

/// All that the child needs, put together before fork: after it nothing may be allocated.
struct Plan {
  const Walls& walls;
  const FileRules& rules;
  const CallFilter& filter;
  std::vector<const char*> argv, environment;
  std::vector<int> descriptors;
  int null, report;
  bool other_user;
};

std::vector<const char*> pointers(const std::vector<std::string>& strings) {
  std::vector<const char*> list;
  list.reserve(strings.size());
  for (const std::string& text : strings) list.push_back(text.c_str());
  list.push_back(nullptr);
  return list;
}

/// Moves the given descriptors to 0, 1, 2, …, and the report's behind them; closes all others.
int arrange_files(const Plan& plan) {
  constexpr int out_of_the_way = 100;
  const int count = static_cast<int>(plan.descriptors.size());
  for (int i = 0; i < count; ++i) {
    const int from = plan.descriptors[static_cast<std::size_t>(i)];
    if (dup2(from >= 0 ? from : plan.null, out_of_the_way + i) < 0) return -1;
  }
  const int report = out_of_the_way + count;
  if (dup2(plan.report, report) < 0) return -1;
  for (int i = 0; i <= count; ++i)
    if (dup2(out_of_the_way + i, i) < 0) return -1;
  fcntl(count, F_SETFD, FD_CLOEXEC);
  platform::close_from(count + 1);
  return count;
}

using platform::limit_resource;

bool set_limits(const Limits& limits) {
  const auto cpu = static_cast<std::uint64_t>(limits.cpu_seconds);
  return limit_resource(RLIMIT_CPU, cpu, cpu + 1) &&  // SIGXCPU first, SIGKILL a second later
         platform::limit_memory(limits.memory_bytes) &&
         limit_resource(RLIMIT_STACK, limits.stack_bytes, limits.stack_bytes) &&
         limit_resource(RLIMIT_FSIZE, limits.file_bytes, limits.file_bytes) &&
         limit_resource(RLIMIT_CORE, 0, 0) && limit_resource(RLIMIT_NOFILE, 64, 64);
}

/// The count of processes is that user's, so it comes after.
bool change_user(const Limits& limits) {
  return become_unprivileged() && limit_resource(RLIMIT_NPROC, limits.processes, limits.processes);
}

[[noreturn]] void become_program(const Plan& plan) {
  int report = plan.report;
  const auto stop = [&](Step step) {
    const Failure failure = {step, errno};
    [[maybe_unused]] const ssize_t written = write(report, &failure, sizeof failure);
    _exit(127);
  };
  setpgid(0, 0);
  umask(077);
  if (!platform::give_up_rights() || !plan.rules.install()) stop(Step::rules);
  const int moved = arrange_files(plan);
  if (moved < 0) stop(Step::files);
  report = moved;
  if (chdir(plan.walls.folder.c_str()) != 0) stop(Step::folder);
  if (!set_limits(plan.walls.limits)) stop(Step::limits);
  if (plan.other_user && !change_user(plan.walls.limits)) stop(Step::user);
  if (!platform::die_with_parent()) stop(Step::user);
  if (!plan.filter.empty()) {
    if (!install_call_filter(plan.filter)) stop(Step::calls);
    execute_behind_filter(plan.argv.data(), plan.environment.data());
  } else {
    execve(plan.argv[0], const_cast<char* const*>(plan.argv.data()),
           const_cast<char* const*>(plan.environment.data()));
  }
  stop(Step::start);
  _exit(127);  // not reached: the compiler does not know that stop() never returns
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

void throw_on_failure(int report, const std::string& program) {
  Failure failure = {};
  ssize_t got;
  do got = read(report, &failure, sizeof failure);
  while (got < 0 && errno == EINTR);
  if (got != sizeof failure) return;  // closed by exec: the program runs
  throw std::runtime_error("cannot confine " + program + ": " +
                           step_names.at(static_cast<std::size_t>(failure.step)) + ": " +
                           std::strerror(failure.error));
}

}  // namespace

ConfinedProcess::ConfinedProcess(const std::vector<std::string>& command,
                                 const std::vector<std::string>& environment, const Walls& walls,
                                 const std::vector<int>& descriptors)
    : cpu_seconds_allowed_(walls.limits.cpu_seconds) {
  const FileRules rules(walls.files);
  const Descriptor null(open("/dev/null", O_RDWR | O_CLOEXEC));
  Pipe report = make_pipe();
  const Plan plan = {walls,
                     rules,
                     call_filter(walls.system_calls),
                     pointers(command),
                     pointers(environment),
                     descriptors,
                     null.number(),
                     report.write.number(),
                     walls.other_user && may_become_unprivileged()};
  if (!plan.filter.empty()) prepare_path(command.at(0));
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error(std::string("cannot fork: ") + std::strerror(errno));
  if (pid_ == 0) become_program(plan);
  setpgid(pid_, pid_);  // here as well: parent or child may come first
  report.write.reset();
  try {
    throw_on_failure(report.read.number(), command.at(0));
  } catch (...) {
    kill();
    throw;
  }
}

ConfinedProcess::~ConfinedProcess() { kill(); }

void ConfinedProcess::kill() {
  if (ending_ || pid_ < 0) return;
  killed_here_ = true;
  ::kill(-pid_, SIGKILL);
  ::kill(pid_, SIGKILL);
  try {
    wait(60);
  } catch (const std::runtime_error&) {  // who waits for an answer is told
  }
}

bool ConfinedProcess::waits_for_processor() const {
  return !ending_ && platform::is_runnable(pid_);
}

bool ConfinedProcess::killed_from_outside() const {
  return ending_ == Ending{true, SIGKILL} && !killed_here_ && cpu_seconds_ < cpu_seconds_allowed_;
}

void ConfinedProcess::give_up() {
  const int error = errno;
  if (pid_ > 0) ::kill(-pid_, SIGKILL);
  pid_ = -1;  // its number may be anybody's from now on
  throw std::runtime_error(std::string("cannot wait for a process: ") + std::strerror(error));
}

std::optional<Ending> ConfinedProcess::wait(double seconds) {
  const Clock::time_point deadline = after(seconds);
  for (useconds_t pause = 50; !ending_; pause = pause < 5000 ? pause * 2 : pause) {
    siginfo_t info = {};
    const auto id = static_cast<id_t>(pid_);
    if (waitid(P_PID, id, &info, WEXITED | WNOHANG | WNOWAIT) != 0 && errno != EINTR) give_up();
    if (info.si_pid == pid_) {
      ::kill(-pid_, SIGKILL);  // what it has started, while its number cannot be anybody else's
      rusage used = {};
      int status = 0;
      wait4(pid_, &status, 0, &used);
      cpu_seconds_ = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
      ending_ = Ending{info.si_code != CLD_EXITED, info.si_status};
    } else if (Clock::now() >= deadline) {
      break;
    } else {
      usleep(pause);
    }
  }
  return ending_;
}

Finished run_confined(const std::vector<std::string>& command,
                      const std::vector<std::string>& environment, const Walls& walls,
                      std::size_t most_output, int input) {
  Pipe text = make_pipe();
  const int out = text.write.number();
  ConfinedProcess process(command, environment, walls, {input, out, out});
  text.write.reset();
  const Clock::time_point deadline = after(walls.limits.wall_seconds);
  Finished finished;
  bool open = true;
  while (open && Clock::now() < deadline) {
    if (!wait_readable(text.read.number(), -1, deadline).first) continue;
    std::string more;
    open = read_some(text.read.number(), more);
    if (finished.output.size() < most_output)
      finished.output += more.substr(0, most_output - finished.output.size());
  }
  const double left = std::chrono::duration<double>(deadline - Clock::now()).count();
  const std::optional<Ending> ending = process.wait(open ? 0 : left);
  finished.timed_out = !ending;
  finished.killed_from_outside = process.killed_from_outside();
  finished.ending = ending.value_or(Ending{true, SIGKILL});
  return finished;
}

}  // namespace tumble::judge
