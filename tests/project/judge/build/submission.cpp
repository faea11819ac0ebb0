/// @file
/// What is taken for a source file, and what is said of everything else.
#include "judge/build/submission.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <string>

using namespace tumble::judge;
namespace fs = std::filesystem;

namespace {

/// A folder for files that are gone afterwards.
struct Folder {
  fs::path path = fs::temp_directory_path() / "tumble-submission-test";
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  fs::path file(const std::string& text) const {
    std::ofstream(path / "f.cpp", std::ios::binary) << text;
    return path / "f.cpp";
  }
};

std::string refusal(const fs::path& file) {
  try {
    read_submission(file);
    return "not refused";
  } catch (const Refused& why) {
    return why.what();
  }
}

}  // namespace

TEST_CASE("text is taken as it is, in any language") {
  const Folder folder;
  const std::string text = "// Größe ω̇ 漢字 🙂\nint main() {}\n";
  CHECK(read_submission(folder.file(text)) == text);
}

TEST_CASE("no file, an empty one, one that is no text, one that is too large") {
  const Folder folder;
  CHECK(refusal(folder.path / "none.cpp").ends_with("does not exist"));
  CHECK(refusal(folder.file("")).ends_with("is empty"));
  CHECK(refusal(folder.file(" \n\t\n")).ends_with("is empty"));
  CHECK(refusal(folder.file(std::string("a\n\0b", 4)))
            .ends_with("has a NUL byte in line 2: save it as UTF-8 text"));
  CHECK(refusal(folder.file(std::string(largest_submission + 1, 'x'))).find("has 262145 bytes") !=
        std::string::npos);
}

TEST_CASE("text that is not UTF-8: read as what it is, and a byte of it is named") {
  const Folder folder;
  CHECK(read_submission(folder.file("// gr\xf6\xdf"
                                    "er\n")) == "// gr\u00f6\u00dfer\n");
  CHECK(read_decoded_submission(folder.file("\x93\n")).was == "Windows-1252");
  CHECK(read_submission(folder.file(std::string("\xff\xfei\0", 4))) == "i");
  CHECK(reason_to_refuse("a\nb\xff\n") ==
        "is not UTF-8 text: see the byte 0xFF in line 2, and save it as UTF-8");
  for (const char* none : {"a\xc3", "\xc0\xaf overlong", "\xed\xa0\x80 a surrogate"})
    CHECK_FALSE_MESSAGE(reason_to_refuse(none).empty(), none);
}

TEST_CASE("a giant is refused without being read") {
  const Folder folder;
  const fs::path file = folder.file("x");
  fs::resize_file(file, std::uintmax_t{1} << 30);  // sparse: a gigabyte that takes no room
  CHECK(refusal(file).find("has 1073741824 bytes") != std::string::npos);
}

TEST_CASE("links, pipes, folders and devices are no files") {
  const Folder folder;
  fs::create_symlink("/etc/passwd", folder.path / "link.cpp");
  CHECK(refusal(folder.path / "link.cpp").ends_with("is a symbolic link, not a file"));
  REQUIRE(mkfifo((folder.path / "pipe.cpp").c_str(), 0600) == 0);
  CHECK(refusal(folder.path / "pipe.cpp").ends_with("is not a regular file"));
  CHECK(refusal(folder.path).ends_with("is not a regular file"));
  fs::create_directory_symlink("/etc", folder.path / "chapter");
  CHECK(refusal(folder.path / "chapter/passwd").ends_with("in a folder that is a symbolic link"));
  CHECK(refusal("/dev/zero").ends_with("is not a regular file"));
}
