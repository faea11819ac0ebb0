/// @file
/// No file that a program writes is one that it reads, or another one that it writes.
#include "support/own_files.hpp"

#include <doctest/doctest.h>

#include "project/harness/refusal.hpp"
#include "project/harness/temporary_folder.hpp"
#include "support/text_file.hpp"

using namespace tumble;
using namespace tumble::support;
namespace fs = std::filesystem;

TEST_CASE("own files: an input is known by every path that leads to it") {
  const test::TemporaryFolder folder;
  const fs::path scene = folder.path() / "scene.json", link = folder.path() / "link.csv";
  write_text(scene, "{}");
  fs::create_symlink(scene, link);
  fs::create_hard_link(scene, folder.path() / "hard.csv");
  for (const fs::path& path : {scene, folder.path() / "." / "scene.json", link,
                               folder.path() / "hard.csv", fs::relative(scene)})
    CHECK_REFUSED(require_own_files({{"your scene", scene}}, {{"--csv", path}}), "--csv",
                  "this file is your scene", "Give another name");
  CHECK_NOTHROW(require_own_files({{"your scene", scene}},
                                  {{"--csv", folder.path() / "new.csv"}, {"--svg", ""}}));
}

TEST_CASE("own files: two outputs are two files, which need not be there yet") {
  const test::TemporaryFolder folder;
  const fs::path x = folder.path() / "x", other = folder.path() / "other";
  fs::create_directory(folder.path() / "real");
  fs::create_symlink(folder.path() / "real", folder.path() / "linked");
  const auto both = [](const fs::path& a, const fs::path& b) {
    require_own_files({}, {{"--csv", a}, {"--impacts", ""}, {"--svg", b}});
  };
  CHECK_REFUSED(both(x, x), "--csv and --svg name the same file", x.string());
  CHECK_REFUSED(both(x, folder.path() / "real" / ".." / "x"), "--csv and --svg");
  CHECK_REFUSED(both(folder.path() / "real" / "x", folder.path() / "linked" / "x"), "--csv");
  CHECK_NOTHROW(both(x, other));
  write_text(x, "");
  CHECK_REFUSED(both(x, x), "--csv and --svg");
  CHECK_NOTHROW(both(x, other));
  CHECK_NOTHROW(both("/dev/null", "/dev/null"));  // it keeps nothing that could be lost
}
