#include "judge/build/confined_compiler.hpp"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace tumble::judge {

namespace {

/// What every step reads: the system, the compiler and an Eigen that may live elsewhere.
std::vector<fs::path> system_files(const Toolchain& tools) {
  std::vector<fs::path> read = {"/usr",
                                "/lib",
                                "/lib32",
                                "/lib64",
                                "/bin",
                                "/etc/alternatives",
                                "/etc/ld.so.cache",
                                "/proc/cpuinfo",
                                "/proc/meminfo"};
  read.push_back(fs::canonical(tools.compiler).parent_path().parent_path());
  for (std::size_t i = 0; i + 1 < tools.flags.size(); ++i)
    if (tools.flags[i] == "-isystem") read.emplace_back(tools.flags[i + 1]);
  return read;
}

}  // namespace

Limits compiler_limits() {
  return {.cpu_seconds = 10,
          .wall_seconds = 120,  // a busy machine gives a twelfth of them
          .memory_bytes = 4ull << 30,
          .stack_bytes = 60ull << 20,
          .file_bytes = 256ull << 20,
          .processes = 64};
}

bool others_may_compile(const Course& course) {
  return others_may_enter(course.toolchain.precompiled.parent_path()) &&
         others_may_enter(course.root / "exercises");
}

ConfinedCompiler::ConfinedCompiler(const Course& course, fs::path folder,
                                   const std::vector<fs::path>& reads)
    : tools_(course.toolchain), folder_(std::move(folder)) {
  fs::create_directories(folder_);
  walls_.folder = folder_;
  walls_.limits = compiler_limits();
  walls_.other_user = others_may_compile(course) && others_may_enter(folder_.parent_path());
  walls_.files.write = {folder_, "/dev/null"};
  walls_.files.read = system_files(tools_);
  walls_.files.read.insert(walls_.files.read.end(), reads.begin(), reads.end());
}

void ConfinedCompiler::hand_over(const std::vector<fs::path>& files) const {
  if (!walls_.other_user || !may_become_unprivileged()) return;
  const auto give = [](const fs::path& path) {
    if (chown(path.c_str(), unprivileged_id, unprivileged_id) != 0)
      throw std::runtime_error("cannot hand " + path.string() + " to the compiler's user");
  };
  give(folder_);
  for (const fs::path& file : files) give(file);
}

Finished ConfinedCompiler::run(const Arguments& arguments) const {
  Arguments command{tools_.compiler};
  command.insert(command.end(), arguments.begin(), arguments.end());
  return run_confined(
      command, {"PATH=/usr/local/bin:/usr/bin:/bin", "LC_ALL=C", "TMPDIR=" + folder_.string()},
      walls_);
}

std::vector<std::string> ConfinedCompiler::functions_in(const fs::path& object) const {
  const fs::path nm = "/usr/bin/nm";
  if (!fs::exists(nm)) return {};
  const Finished step =
      run_confined({nm.string(), "-C", "--defined-only", object.string()}, {"LC_ALL=C"}, walls_);
  std::istringstream in(step.output);
  std::vector<std::string> functions;
  for (std::string line; std::getline(in, line);)  // "0000000000000000 T quaternions::prod(double)"
    if (const auto at = line.find(" T "); at != std::string::npos && line.ends_with(')'))
      functions.push_back(line.substr(at + 3));
  return functions;
}

bool ran_into_limits(const Finished& step) {
  constexpr std::array of_limits = {SIGXCPU, SIGXFSZ, SIGKILL};
  if (step.timed_out) return true;
  if (step.ending.by_signal)
    return std::find(of_limits.begin(), of_limits.end(), step.ending.number) != of_limits.end();
  constexpr std::array complaints = {"out of memory", "cannot allocate", "memory exhausted",
                                     "Killed",        "CPU time limit",  "File size limit"};
  return std::any_of(complaints.begin(), complaints.end(), [&](const char* complaint) {
    return step.output.find(complaint) != std::string::npos;
  });
}

WorkerProgram confined_worker(const fs::path& folder, const fs::path& worker) {
  const fs::perms pass = fs::perms::owner_all | fs::perms::others_exec | fs::perms::group_exec;
  fs::permissions(folder, pass);
  fs::permissions(worker, pass | fs::perms::others_read);
  const fs::path empty = folder / "empty";
  fs::create_directory(empty);
  fs::permissions(empty, fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_exec);
  Walls walls;
  walls.folder = empty;
  walls.other_user = others_may_enter(folder.parent_path());
  walls.files.read = {worker};
  walls.system_calls = CallRules::worker;
  return {worker, walls, {}};
}

}  // namespace tumble::judge
