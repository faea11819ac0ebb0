/// @file
/// Serves the site to the browsers of this machine: the exercises in a page need a server, for a
/// browser fetches nothing from files.
#include <httplib.h>
#include <spawn.h>

#include <iostream>
#include <stdexcept>

#include "support/command_line.hpp"

extern char** environ;

namespace {

constexpr const char* this_machine = "127.0.0.1";

/// A port that another server has is taken: two sites at one address would answer by turns.
void take_alone(int socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

void prepare(httplib::Server& server, const std::string& site) {
  server.set_socket_options(take_alone);
  server.set_mount_point("/", site);
  server.set_file_extension_and_mimetype_mapping("mjs", "text/javascript");
  server.set_file_extension_and_mimetype_mapping("wasm", "application/wasm");
  // What is made again is seen at the next look.
  server.set_default_headers(
      {{"Cache-Control", "no-cache"}, {"X-Content-Type-Options", "nosniff"}});
}

/// @param port 0: any that is free
/// @return the port
int bind(httplib::Server& server, int port) {
  if (port == 0)
    port = server.bind_to_any_port(this_machine);
  else if (!server.bind_to_port(this_machine, port))
    port = -1;
  if (port < 0) throw std::runtime_error("cannot listen at this port: another program does");
  return port;
}

/// That program may be slow, or fail. So we print the address in any case.
void open_browser(const std::string& program, const std::string& address) {
  std::string name = program, argument = address;
  char* const words[] = {name.data(), argument.data(), nullptr};
  pid_t process = 0;
  posix_spawnp(&process, words[0], nullptr, nullptr, words, environ);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("serves the book to browsers on this machine", "./tumble book --serve");
  std::string site, opener;
  int port = 0;
  app.add_option("site", site, "the folder with index.html")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_option("--port", port, "on 127.0.0.1, instead of one that is free")
      ->check(CLI::Range(0, 65535));
  app.add_option("--open", opener, "a program that opens an address in a browser");
  return tumble::support::run_command_line(app, argc, argv, [&] {
    httplib::Server server;
    prepare(server, site);
    port = bind(server, port);
    const std::string address = "http://127.0.0.1:" + std::to_string(port) + "/";
    std::cout << address << std::endl;
    std::cerr << "tumble: the book is at this address until you press Ctrl-C\n";
    if (!opener.empty()) open_browser(opener, address);
    return server.listen_after_bind() ? 0 : 2;
  });
}
