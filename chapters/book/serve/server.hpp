#pragma once
/// @file
/// A server of a folder's files to browsers on this machine, and to nobody else.

#include <cstdint>
#include <filesystem>
#include <string>

namespace tumble::book {

class Server {
 public:
  /// Listens on 127.0.0.1 from now on. @param port 0: any that is free
  /// @throws std::runtime_error if the port is taken
  Server(const std::filesystem::path& site, std::uint16_t port);
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server();

  /// "http://127.0.0.1:8080/"
  std::string address() const;
  /// Answers, until the process ends.
  [[noreturn]] void run() const;

 private:
  std::filesystem::path site_;
  int listening_ = -1;
};

}  // namespace tumble::book
