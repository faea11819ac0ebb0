#pragma once
/// @file
/// A copy of the site with editors in it, served as ./tumble book --serve does.

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "book/tool/editors.hpp"
#include "project/browser/site.hpp"
#include "project/harness/served_folder.hpp"
#include "project/harness/temporary_folder.hpp"
#include "support/text_file.hpp"

namespace tumble::test {

class ServedSite {
 public:
  /// Exercises that were built: ./tumble book --exercises.
  static std::filesystem::path exercises() {
    const char* folder = std::getenv("TUMBLE_EXERCISES");
    return folder ? folder : "";
  }
  /// CodeMirror, as they have it.
  static std::filesystem::path editor() { return exercises() / "codemirror"; }

  /// With the compiler and the judge.
  ServedSite() {
    copy_site();
    book::add_editors(folder_.path() / "site", exercises());
    server_.emplace(folder_.path() / "site");
  }

  /// With a stand-in for both, which gives the verdicts; client.mjs itself is true_client.mjs.
  /// @param client the text of client.mjs
  explicit ServedSite(const std::string& client) {
    namespace fs = std::filesystem;
    const fs::path root = std::getenv("TUMBLE_ROOT"), made = folder_.path() / "made";
    copy_site();
    fs::copy(root / "tests/judge/page/site", made, fs::copy_options::recursive);
    fs::copy(editor(), made / "codemirror");
    fs::rename(made / "client.mjs", made / "true_client.mjs");
    folder_.write("made/client.mjs", client);
    folder_.write("made/units.json", units(root).dump());
    folder_.write("made/manifest.json",
                  R"({"version":"1","files":[],"total_wire":33100000,"engine":true})");
    book::add_editors(folder_.path() / "site", made);
    server_.emplace(folder_.path() / "site");
  }

  std::string address(const std::string& page) const { return server_->address() + page; }
  std::string from_disk(const std::string& page) const {
    return "file://" + (folder_.path() / "site" / page).string();
  }

  /// From now on nothing answers.
  void stop() { server_.reset(); }

 private:
  void copy_site() {
    std::filesystem::copy(site_folder(), folder_.path() / "site",
                          std::filesystem::copy_options::recursive);
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

  TemporaryFolder folder_;
  std::optional<ServedFolder> server_;
};

}  // namespace tumble::test
