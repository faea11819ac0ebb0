#pragma once
/// @file
/// A copy of the site with editors in it, served as ./tumble book --serve does. A stand-in gives
/// the verdicts: there is no compiler.

#include <signal.h>
#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "book/tool/editors.hpp"
#include "project/browser/site.hpp"
#include "project/harness/temporary_folder.hpp"
#include "support/text_file.hpp"

namespace tumble::test {

class ServedSite {
 public:
  /// @param client the text of client.mjs
  explicit ServedSite(const std::string& client) {
    namespace fs = std::filesystem;
    const fs::path root = std::getenv("TUMBLE_ROOT"), made = folder_.path() / "made";
    fs::copy(site_folder(), folder_.path() / "site", fs::copy_options::recursive);
    fs::copy(root / "tests/judge/page/site", made, fs::copy_options::recursive);
    copy_codemirror(made / "codemirror");
    folder_.write("made/client.mjs", client);
    folder_.write("made/units.json", units(root).dump());
    folder_.write("made/manifest.json", R"({"version":"1","files":[],"total_wire":33100000})");
    book::add_editors(folder_.path() / "site", made);
    start();
  }
  ServedSite(const ServedSite&) = delete;
  ServedSite& operator=(const ServedSite&) = delete;
  ~ServedSite() {
    kill(process_, SIGTERM);
    pclose(server_);
  }

  std::string address(const std::string& page) const { return address_ + page; }

 private:
  static void copy_codemirror(const std::filesystem::path& to) {
    std::filesystem::create_directories(to);
    for (const char* file : {"lib/codemirror.js", "lib/codemirror.css", "mode/clike/clike.js",
                             "addon/edit/matchbrackets.js", "addon/edit/closebrackets.js"})
      std::filesystem::copy(std::filesystem::path(std::getenv("TUMBLE_CODEMIRROR")) / file, to);
  }

  static nlohmann::json units(const std::filesystem::path& root) {
    nlohmann::json all = nlohmann::json::array();
    for (const auto& [number, name] : {std::pair{"4.1", "product"}, {"4.2", "inverse"}}) {
      const std::string id = std::string("04_quaternions/") + name;
      all.push_back({{"id", id},
                     {"number", number},
                     {"chapter", "04_quaternions"},
                     {"name", name},
                     {"stub", support::read_text(root / "exercises" / (id + ".cpp"))},
                     {"hints", {"One `a`.", "Two.", "Three."}}});
    }
    return all;
  }

  /// The shell says its number, and becomes the server, which says its address.
  void start() {
    const std::string command = "echo $$; exec '" + std::string(std::getenv("TUMBLE_SERVE")) +
                                "' '" + (folder_.path() / "site").string() + "' 2>/dev/null";
    server_ = popen(command.c_str(), "r");
    process_ = std::stoi(line());
    address_ = line();
  }

  std::string line() {
    std::string text;
    for (int c = std::fgetc(server_); c != EOF && c != '\n'; c = std::fgetc(server_))
      text += static_cast<char>(c);
    return text;
  }

  TemporaryFolder folder_;
  std::FILE* server_ = nullptr;
  pid_t process_ = -1;
  std::string address_;
};

}  // namespace tumble::test
