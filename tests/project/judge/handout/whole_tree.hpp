#pragma once
/// @file
/// A hand-out of all chapters, as an instructor makes it.

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "project/harness/command.hpp"
#include "project/harness/skip.hpp"
#include "project/harness/temporary_folder.hpp"

namespace tumble::test {

namespace fs = std::filesystem;

inline fs::path root() { return std::getenv("TUMBLE_ROOT"); }

/// Presets with sanitizers build the judge of the fixture only: then nothing can be handed out.
inline bool can_hand_out() {
  if (fs::exists(std::getenv("TUMBLE_JUDGE"))) return true;
  skip("the course's judge is not built with this preset");
  return false;
}

inline std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Makes one of these chapters: "1-4".
class HandedOut {
 public:
  explicit HandedOut(const std::string& chapters) {
    const CommandResult made =
        run_command(std::string("'") + std::getenv("TUMBLE_JUDGE") + "' handout --chapters " +
                    chapters + " '" + tree().string() + "'");
    REQUIRE_MESSAGE(made.status == 0, made.output);
  }
  fs::path tree() const { return folder_.path() / "tree"; }

  /// Its files with one of these endings, from the root of the tree.
  std::vector<fs::path> files(std::initializer_list<const char*> endings) const {
    std::vector<fs::path> paths;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(tree()))
      for (const char* ending : endings)
        if (entry.is_regular_file() && entry.path().extension() == ending)
          paths.push_back(entry.path().lexically_relative(tree()));
    std::sort(paths.begin(), paths.end());
    return paths;
  }

 private:
  TemporaryFolder folder_;
};

/// "1-11", or whatever the last chapter is.
inline std::string all_chapters() {
  int last = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(root() / "solutions"))
    if (entry.is_directory()) last = std::max(last, std::stoi(entry.path().filename().string()));
  return "1-" + std::to_string(last);
}

}  // namespace tumble::test
