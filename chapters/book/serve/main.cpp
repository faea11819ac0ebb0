/// @file
/// Serves the site to the browsers of this machine: the exercises in a page need a server, for a
/// browser fetches nothing from files.
#include <spawn.h>

#include <iostream>

#include "book/serve/server.hpp"
#include "support/command_line.hpp"

extern char** environ;

namespace {

/// Whoever opens it may be slow, or fail: the address is said in any case.
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
  std::uint16_t port = 0;
  app.add_option("site", site, "the folder with index.html")
      ->required()
      ->check(CLI::ExistingDirectory);
  app.add_option("--port", port, "on 127.0.0.1, instead of one that is free");
  app.add_option("--open", opener, "a program that opens an address in a browser");
  return tumble::support::run_command_line(app, argc, argv, [&]() -> int {
    const tumble::book::Server server(site, port);
    std::cout << server.address() << std::endl;
    std::cerr << "tumble: the book is at this address until you press Ctrl-C\n";
    if (!opener.empty()) open_browser(opener, server.address());
    server.run();
  });
}
