/// @file
/// Files that cannot be read or written: who asked for them is told why.
#include "support/text_file.hpp"

#include <doctest/doctest.h>

using namespace tumble::support;

TEST_CASE("text files: why one cannot be read or written is said") {
  CHECK_THROWS_WITH(read_text("/no/such/file"),
                    "cannot read /no/such/file: No such file or directory");
  CHECK_THROWS_WITH(write_text("/no/such/file", "x"),
                    "cannot write /no/such/file.new: No such file or directory");
  if (std::filesystem::exists("/dev/full"))
    CHECK_THROWS_WITH(write_text("/dev/full", "x"),
                      "cannot write /dev/full: No space left on device");
}
