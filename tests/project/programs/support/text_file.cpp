/// @file
/// Files that cannot be read or written: who asked for them is told why.
#include "support/text_file.hpp"

#include <doctest/doctest.h>

#include <thread>

#include "project/harness/temporary_folder.hpp"

using namespace tumble::support;

TEST_CASE("text files: why one cannot be read or written is said") {
  CHECK_THROWS_WITH(read_text("/no/such/file"),
                    "cannot read /no/such/file: No such file or directory");
  CHECK_THROWS_WITH(write_text("/no/such/file", "x"),
                    "cannot write /no/such/file: No such file or directory");
  if (std::filesystem::exists("/dev/full"))
    CHECK_THROWS_WITH(write_text("/dev/full", "x"),
                      "cannot write /dev/full: No space left on device");
}

TEST_CASE("text files: two may write the same one at the same time, and nothing else is left") {
  const tumble::test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "grades.csv";
  const auto write_often = [&file] {
    for (int i = 0; i < 2000; ++i) write_text(file, "passed");
  };
  std::thread other(write_often);
  CHECK_NOTHROW(write_often());
  other.join();
  CHECK(read_text(file) == "passed");
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}
