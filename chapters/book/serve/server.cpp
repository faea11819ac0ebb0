#include "book/serve/server.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "book/serve/answer.hpp"

namespace tumble::book {

namespace {

constexpr std::size_t longest_request = 16384;
constexpr int backlog = 64;

sockaddr_in here(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  return address;
}

/// A browser that has gone must not end the server.
bool send_all(int connection, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t sent = send(connection, bytes, count, MSG_NOSIGNAL);
    if (sent <= 0) return false;
    bytes += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return true;
}

/// The first line of a request; the headers are read and mean nothing here.
std::string request_on(int connection) {
  std::string request;
  std::array<char, 4096> bytes{};
  while (request.find("\r\n\r\n") == std::string::npos && request.size() < longest_request) {
    const ssize_t count = recv(connection, bytes.data(), bytes.size(), 0);
    if (count <= 0) return {};
    request.append(bytes.data(), static_cast<std::size_t>(count));
  }
  return request.substr(0, request.find("\r\n"));
}

void send_file(int connection, const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::array<char, 65536> bytes{};
  while (in.read(bytes.data(), bytes.size()), in.gcount() > 0)
    if (!send_all(connection, bytes.data(), static_cast<std::size_t>(in.gcount()))) return;
}

void serve(int connection, const std::filesystem::path& site) {
  const timeval patience{30, 0};
  setsockopt(connection, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  setsockopt(connection, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  if (const std::string request = request_on(connection); !request.empty()) {
    const Answer answer = answer_to(site, request);
    const std::string head = answer.head();
    if (send_all(connection, head.data(), head.size()) && answer.with_content)
      send_file(connection, answer.file);
  }
  close(connection);
}

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what + ": " + std::system_category().message(errno));
}

}  // namespace

Server::Server(const std::filesystem::path& site, std::uint16_t port)
    : site_(std::filesystem::canonical(site)), listening_(socket(AF_INET, SOCK_STREAM, 0)) {
  if (listening_ < 0) fail("no socket");
  const int yes = 1;
  setsockopt(listening_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  const sockaddr_in address = here(port);
  if (bind(listening_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      listen(listening_, backlog) != 0) {
    close(listening_);
    fail("127.0.0.1:" + std::to_string(port) + " cannot be used");
  }
}

Server::~Server() { close(listening_); }

std::string Server::address() const {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  getsockname(listening_, reinterpret_cast<sockaddr*>(&address), &size);
  return "http://127.0.0.1:" + std::to_string(ntohs(address.sin_port)) + "/";
}

void Server::run() const {
  while (true) {
    const int connection = accept(listening_, nullptr, nullptr);
    if (connection < 0 && (errno == EBADF || errno == EINVAL)) fail("the server has ended");
    if (connection >= 0)
      std::thread([connection, site = site_] {
        try {
          serve(connection, site);
        } catch (const std::exception&) {
          close(connection);  // a file that went away between two looks
        }
      }).detach();
  }
}

}  // namespace tumble::book
