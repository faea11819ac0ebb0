/// @file
/// The walls around a program, tried with the system's own programs.
#include "judge/sandbox/confined_process.hpp"

#include <doctest/doctest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>

#include "project/harness/skip.hpp"

using namespace tumble::judge;

namespace {

Walls usual_walls() {
  Walls walls;
  walls.folder = "/";
  walls.files.read = {"/usr", "/bin", "/lib", "/lib64", "/etc/ld.so.cache"};
  walls.files.write = {"/dev/null"};
  walls.limits.processes = 64;
  return walls;
}

Finished shell(const std::string& script, const Walls& walls = usual_walls()) {
  return run_confined({"/bin/sh", "-c", script}, {"PATH=/usr/bin:/bin"}, walls);
}

/// Whether this machine has not got the wall; the test case then counts as skipped.
bool lacks(Wall wall) {
  for (const MissingWall& each : missing_walls()) {
    if (each.wall != wall) continue;
    tumble::test::skip("this machine has no " + name_of(wall) + ": " + each.why);
    return true;
  }
  return false;
}

}  // namespace

TEST_CASE("a program runs, and what it prints and how it ends is known") {
  const Finished finished = shell("echo out; echo err >&2; exit 3");
  CHECK(finished.output == "out\nerr\n");
  CHECK(finished.ending == Ending{false, 3});
}

TEST_CASE("it has the environment that it is given and no other") {
  setenv("TUMBLE_SECRET", "token", 1);
  CHECK(run_confined({"/usr/bin/env"}, {"ONLY=this"}, usual_walls()).output == "ONLY=this\n");
}

TEST_CASE("it has no open files but its own") {
  const std::ifstream secret("/etc/passwd");
  REQUIRE(secret);
  Walls walls = usual_walls();
  walls.files.read.emplace_back("/proc");
  // ls opens the folder itself as 3.
  CHECK(run_confined({"/bin/ls", "/proc/self/fd"}, {}, walls).output == "0\n1\n2\n3\n");
}

TEST_CASE("it opens no file that is not listed") {
  if (lacks(Wall::files)) return;
  CHECK(shell("cat /etc/passwd").ending != Ending{false, 0});
  CHECK(shell("cat /etc/passwd").output.find("root:") == std::string::npos);
  const auto file = std::filesystem::temp_directory_path() / "tumble-wall-test";
  shell("echo x > " + file.string());
  CHECK_FALSE(std::filesystem::exists(file));
}

TEST_CASE("root's programs run as nobody") {
  if (lacks(Wall::other_user)) return;
  CHECK(shell("id -u; id -g; id -G").output == "65534\n65534\n65534\n");
}

TEST_CASE("time, memory and file size end") {
  Walls walls = usual_walls();
  walls.limits.cpu_seconds = 1;
  CHECK(shell("while :; do :; done", walls).ending == Ending{true, SIGXCPU});

  walls.limits.wall_seconds = 0.2;
  const auto start = std::chrono::steady_clock::now();
  CHECK(shell("sleep 30", walls).timed_out);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));

  walls = usual_walls();
  walls.limits.memory_bytes = 64 << 20;
  walls.files.read.emplace_back("/dev/zero");
  CHECK(shell("head -c 200000000 /dev/zero | tail", walls).output.find("exhausted") !=
        std::string::npos);
}

TEST_CASE("a system that lets nobody wait for it is said at once") {
  signal(SIGCHLD, SIG_IGN);
  const auto start = std::chrono::steady_clock::now();
  CHECK_THROWS_WITH(shell("exit 3"), "cannot wait for a process: No child processes");
  signal(SIGCHLD, SIG_DFL);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
}

TEST_CASE("what this machine grants less of is said in numbers that are not 0") {
  const pid_t child = fork();
  if (child == 0) {
    const rlimit small{200 << 10, 200 << 10};
    const bool said = setrlimit(RLIMIT_STACK, &small) == 0 &&
                      lowered_limits(Limits()) == "200 KB of stack instead of 8 MB";
    _exit(said ? 0 : 1);
  }
  int status = 1;
  waitpid(child, &status, 0);
  CHECK(status == 0);
}

TEST_CASE("what it has started ends with it") {
  const Finished finished = shell("sleep 1000 >/dev/null 2>&1 & echo $!");
  const pid_t orphan = std::stoi(finished.output);
  usleep(100000);
  // A zombie that nobody has reaped yet still has a number; it runs nothing.
  std::ifstream state("/proc/" + std::to_string(orphan) + "/stat");
  std::string word;
  for (int i = 0; i < 3; ++i) state >> word;
  CHECK((!state || word == "Z"));
}

TEST_CASE("a program that is not there, or a folder, is said plainly") {
  CHECK_THROWS_WITH(
      run_confined({"/no/such/program"}, {}, usual_walls()),
      doctest::Contains("cannot confine /no/such/program: the program: No such file"));
  Walls walls = usual_walls();
  walls.folder = "/no/such/folder";
  CHECK_THROWS_WITH(shell("true", walls), doctest::Contains("its folder: No such file"));
}

TEST_CASE("behind the list of system calls only the prepared program starts, and no other") {
  if (lacks(Wall::system_calls)) return;
  Walls walls = usual_walls();
  walls.system_calls = CallRules::sanitizer;  // a shell comes up behind this one
  CHECK(shell("echo alive", walls).output == "alive\n");
  CHECK(shell("exec /bin/echo other", walls).output.find("other\n") == std::string::npos);
  CHECK(shell("(echo forked)", walls).output.find("forked\n") == std::string::npos);
  CHECK(shell("kill -0 $$ && echo signalled", walls).output.find("signalled\n") ==
        std::string::npos);
}

TEST_CASE(
    "behind the sanitizers' filter files are read only, where the list of files would let them") {
  if (lacks(Wall::system_calls)) return;
  const auto file = std::filesystem::temp_directory_path() / "tumble-read-only-test";
  std::ofstream(file) << "kept";
  std::filesystem::permissions(file, std::filesystem::perms::all);
  Walls walls = usual_walls();
  walls.files.write.push_back(file.parent_path());
  walls.limits.file_bytes = 1000;
  walls.system_calls = CallRules::sanitizer;
  shell("echo changed > " + file.string(), walls);
  CHECK(std::filesystem::file_size(file) == 4);
  CHECK(shell("read word < " + file.string() + "; echo $word", walls).output == "kept\n");
  std::filesystem::remove(file);
}
