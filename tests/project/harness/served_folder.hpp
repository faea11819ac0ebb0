#pragma once
/// @file
/// A folder that a server shows to the browsers of this machine, as long as the object lives.

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "tumble/core/require.hpp"

namespace tumble::test {

/// The server of the book; empty if it is not built.
inline std::string server_program() {
  const char* program = std::getenv("TUMBLE_SERVE");
  return program && std::filesystem::exists(program) ? program : "";
}

class ServedFolder {
 public:
  explicit ServedFolder(const std::filesystem::path& folder) {
    const std::string program = server_program();
    std::array<int, 2> ends{};
    require(pipe2(ends.data(), O_CLOEXEC) == 0, "no pipe to the server");
    process_ = fork();
    if (process_ == 0) {
      dup2(ends[1], STDOUT_FILENO);
      execl(program.c_str(), program.c_str(), folder.c_str(), static_cast<char*>(nullptr));
      _exit(127);
    }
    close(ends[1]);
    // Its first line is the address.
    for (char letter = 0; read(ends[0], &letter, 1) == 1 && letter != '\n';) address_ += letter;
    close(ends[0]);
    require(address_.starts_with("http://127.0.0.1:"), program, " does not serve ",
            folder.string());
  }
  ServedFolder(const ServedFolder&) = delete;
  ServedFolder& operator=(const ServedFolder&) = delete;
  ~ServedFolder() {
    kill(process_, SIGTERM);
    waitpid(process_, nullptr, 0);
  }

  /// "http://127.0.0.1:8080/"
  const std::string& address() const { return address_; }

 private:
  pid_t process_ = -1;
  std::string address_;
};

}  // namespace tumble::test
