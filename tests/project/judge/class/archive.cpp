/// @file
/// Archives: what is read, and every way of doing harm that is refused.
#include "judge/class/archive.hpp"

#include <doctest/doctest.h>

#include <fstream>

#include "judge/build/work_folder.hpp"
#include "project/judge/class/archives.hpp"

using namespace tumble::judge;
using tumble::test::Entry;
using tumble::test::write_archive;

namespace {

Unpacked unpacked(const std::string& name, const std::vector<Entry>& entries) {
  const WorkFolder folder;
  write_archive(folder.path() / name, entries);
  return unpack(folder.path() / name);
}

Unpacked unpacked_bytes(const std::string& bytes) {
  const WorkFolder folder;
  std::ofstream(folder.path() / "a.zip", std::ios::binary) << bytes;
  return unpack(folder.path() / "a.zip");
}

}  // namespace

TEST_CASE("archives: the source files, whatever else is in them") {
  const std::string umlauts = "// Größe\nint f();\n";
  for (const char* name : {"a.zip", "a.tar.gz"}) {
    const Unpacked result = unpacked(name, {{"work/", "", AE_IFDIR},
                                            {"work/04_quaternions/product.cpp", umlauts},
                                            {"work/report.pdf", std::string(1 << 20, '\xff')},
                                            {"./twice.cpp", std::string("\0\xfe", 2)}});
    CAPTURE(name);
    CHECK(result.refused == "");
    REQUIRE(result.files.size() == 2);
    CHECK(result.files.at("work/04_quaternions/product.cpp") == umlauts);
    CHECK(result.files.at("./twice.cpp") == std::string("\0\xfe", 2));  // judged as what it is
  }
}

TEST_CASE("archives: paths, links and devices that lead out of them") {
  const std::pair<Entry, const char*> harmful[] = {
      {{"../../etc/product.cpp", "x"}, "has a path that leads out of it: ../../etc/product.cpp"},
      {{"a/../../b.cpp", "x"}, "has a path that leads out of it"},
      {{"/etc/cron.d/b.cpp", "x"}, "has a path that leads out of it"},
      {{"a\\..\\b.cpp", "x"}, "has a path that leads out of it"},
      {{"product.cpp", "", AE_IFLNK, "/etc/shadow"}, "has a link in it: product.cpp"},
      {{"product.cpp", "", AE_IFREG, "/etc/shadow"}, "has a link in it: product.cpp"},
      {{"product.cpp", "", AE_IFIFO}, "neither a file nor a folder: product.cpp"},
      {{"product.cpp", "", AE_IFCHR}, "neither a file nor a folder: product.cpp"}};
  for (const auto& each : harmful) {
    const Unpacked result = unpacked("a.tar.gz", {{"harmless.cpp", "int x;"}, each.first});
    CAPTURE(each.first.path);
    CHECK_MESSAGE(result.refused.find(each.second) != std::string::npos, result.refused);
    CHECK(result.files.empty());
  }
  CHECK(unpacked("a.zip", {{"../b.cpp", "x"}}).refused ==
        "has a path that leads out of it: ../b.cpp");
  CHECK(unpacked("a.zip", {{"b.cpp", "", AE_IFLNK, "/"}}).refused == "has a link in it: b.cpp");
}

TEST_CASE("archives: too many, too large, or none at all") {
  const std::string zeros(20 << 20, '\0');
  const std::vector<Entry> bomb(14, {"zeros.txt", zeros});  // 280 kB packed
  CHECK(unpacked("a.zip", bomb).refused == "unpacks to more than 256 MB");
  CHECK(unpacked("a.tar.gz", bomb).refused == "unpacks to more than 256 MB");
  const std::vector<Entry> crowd(most_entries + 1, {"x.txt", ""});
  CHECK(unpacked("a.tar.gz", crowd).refused == "has more than 20000 entries");
  CHECK(unpacked_bytes(std::string(largest_archive + 1, 'x')).refused.ends_with("more than 32 MB"));
  for (const char* bytes : {"", "hello", "PK\x03\x04 and so on"})
    CHECK_MESSAGE(unpacked_bytes(bytes).refused.starts_with("cannot be unpacked"), bytes);
  CHECK(unpack("/nowhere.zip").refused == "cannot be read");
}

TEST_CASE("archives: a damaged one is refused as a whole") {
  const WorkFolder folder;
  const auto file = folder.path() / "a.tar.gz";
  write_archive(file, {{"a.cpp", "int a;"}, {"b.cpp", std::string(5000, 'b')}});
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  CHECK(unpack(file).refused.starts_with("cannot be unpacked"));
  CHECK(unpack(file).files.empty());
}
