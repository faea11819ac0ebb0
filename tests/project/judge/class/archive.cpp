/// @file
/// Archives: what is read, and every way of doing harm that is refused.
#include "judge/class/archive.hpp"

#include <doctest/doctest.h>
#include <signal.h>
#include <sys/stat.h>

#include <fstream>

#include "judge/build/work_folder.hpp"
#include "judge/sandbox/confined_process.hpp"
#include "project/judge/class/archives.hpp"
#include "project/judge/class/without_files.hpp"
#include "support/text_file.hpp"

using namespace tumble::judge;
using tumble::test::Entry;
using tumble::test::WithoutFiles;
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

TEST_CASE("archives: a machine that fails is not the archive's fault") {
  const Finished killed{{true, SIGKILL}, "", false, true},
      starved{{true, SIGKILL}, "", true, false}, no_disk{{false, disk_failed}, "", false, false};
  for (const Finished& reader : {killed, starved, no_disk})
    CHECK_THROWS_AS(why_not_read(reader, "ben.zip"), std::runtime_error);
  CHECK(why_not_read({{true, SIGXCPU}, "", false, false}, "") == "takes too long to unpack");
  CHECK(why_not_read({{true, SIGSEGV}, "", false, false}, "").find("crashed") != std::string::npos);
  CHECK(why_not_read({{false, 0}, "", false, false}, "") == "");
}

TEST_CASE("archives: no file can be opened any more, and a pipe of an archive's name") {
  const WorkFolder folder;
  write_archive(folder.path() / "a.zip", {{"product.cpp", "int x;"}});
  const WithoutFiles none;
  CHECK_THROWS_AS(unpack(folder.path() / "a.zip"), std::runtime_error);
  none.end();
  CHECK(unpack(folder.path() / "a.zip").refused == "");
  REQUIRE(mkfifo((folder.path() / "pipe.zip").c_str(), 0600) == 0);
  CHECK(unpack(folder.path() / "pipe.zip").refused == "cannot be read");
}

TEST_CASE("archives: too many, too large, or none at all") {
  const std::string zeros(20 << 20, '\0');
  const std::vector<Entry> bomb(14, {"zeros.txt", zeros});  // 280 kB packed
  CHECK(unpacked("a.zip", bomb).refused == "unpacks to more than 256 MB");
  CHECK(unpacked("a.tar.gz", bomb).refused == "unpacks to more than 256 MB");
  const std::vector<Entry> crowd(most_entries + 1, {"x.txt", ""});
  CHECK(unpacked("a.tar.gz", crowd).refused == "has more than 20000 entries");
  CHECK(unpacked_bytes(std::string(largest_archive + 1, 'x')).refused.ends_with("more than 32 MB"));
  CHECK(unpack("/nowhere.zip").refused == "cannot be read");
}

TEST_CASE("archives: what is wrong with one that cannot be read") {
  CHECK(unpacked_bytes("").refused == "is empty");
  CHECK(unpacked_bytes("hello").refused == "is no archive, whatever its name says");
  CHECK(unpacked_bytes("Rar!\x1a\x07 and so on").refused ==
        "is a RAR archive, and cannot be read here: ask for a .zip");
  CHECK(unpacked_bytes("%PDF-1.4").refused == "is a PDF, and cannot be read here: ask for a .zip");
  CHECK(unpacked_bytes("PK\x03\x04 and so on").refused.starts_with("is damaged"));
  const Unpacked both = unpacked("a.zip", {{"b.zip", ""}, {"c.zip", "Rar!\x1a\x07"}});
  REQUIRE(both.notes.size() == 2);
  CHECK(both.notes[0] == "b.zip in it is empty");
  CHECK(both.notes[1] == "c.zip in it is a RAR archive, and cannot be read here: ask for a .zip");
}

TEST_CASE("archives: of two entries of one path the last counts, and that is said") {
  for (const char* name : {"a.zip", "a.tar.gz"}) {
    const Unpacked result = unpacked(
        name,
        {{"a.cpp", "int old;"}, {"b.cpp", "int b;"}, {"b.cpp", "int b;"}, {"./a.cpp", "int a;"}});
    REQUIRE(result.files.size() == 2);
    CHECK(result.files.at("./a.cpp") == "int a;");
    CHECK(result.notes == std::vector<std::string>{"a.cpp is in it 2 times: counted the last"});
  }
  const WorkFolder folder;
  write_archive(folder.path() / "all.zip", {{"Ann_1_assignsubmission_file_/a.cpp", "int old;"},
                                            {"Ann_1_assignsubmission_file_/a.cpp", "int a;"}});
  const auto left_out = unpack_class(folder.path() / "all.zip", folder.path() / "all");
  REQUIRE(left_out.size() == 1);
  CHECK(left_out[0].why == "has several entries: counted the last");
  CHECK_FALSE(left_out[0].is_work);
}

TEST_CASE("archives: a damaged one is refused as a whole") {
  const WorkFolder folder;
  const auto file = folder.path() / "a.tar.gz";
  write_archive(file, {{"a.cpp", "int a;"}, {"b.cpp", std::string(5000, 'b')}});
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  CHECK(unpack(file).refused.starts_with("is damaged"));
  CHECK(unpack(file).files.empty());
}

TEST_CASE("archives: a checksum that is wrong is damage, not an empty file") {
  const WorkFolder folder;
  const fs::path file = folder.path() / "a.zip";
  write_archive(file, {{"a.cpp", "int a = 1;"}, {"b.cpp", "int b;"}});
  std::string bytes = tumble::support::read_text(file);
  const auto spoil = [&](const std::string& header, std::size_t at) {  // of the first file
    if (const std::size_t found = bytes.find(header); found != std::string::npos)
      bytes[found + at] = static_cast<char>(~bytes[found + at]);
  };
  spoil("PK\x03\x04", 14);  // its checksum, wherever it is written
  spoil("PK\x07\x08", 4);
  spoil("PK\x01\x02", 16);
  std::ofstream(file, std::ios::binary) << bytes;
  CHECK(unpack(file).refused.starts_with("is damaged (ZIP bad CRC"));
  const std::vector<EntryLeftOut> left_out = unpack_class(file, folder.path() / "all");
  REQUIRE(left_out.size() == 1);
  CHECK(left_out[0].path == "a.cpp");
}

TEST_CASE("archives: all formats that are read, and sources however they are spelt") {
  for (const char* name :
       {"a.ZIP", "a.tar", "a.tar.gz", "a.tar.bz2", "a.tar.xz", "a.tar.zst", "a.7z"}) {
    const Unpacked result =
        unpacked(name, {{"Größe/Product.CPP", "int a;"}, {"b.cpp.txt", "int b;"}, {"c.pdf", "c"}});
    CAPTURE(name);
    CHECK(result.refused == "");
    CHECK(result.files.size() == 2);
    CHECK(result.files.contains("Größe/Product.CPP"));
    CHECK(result.others == std::vector<std::string>{"c.pdf"});
  }
}

TEST_CASE("archives: one in another, and no deeper") {
  using tumble::test::archive_bytes;
  const std::string inner = archive_bytes("i.zip", {{"product.cpp", "int a;"}, {"x.pdf", "x"}});
  const std::string deep = archive_bytes("d.zip", {{"i.zip", inner}});
  const std::string harmful = archive_bytes("h.tar.gz", {{"../b.cpp", "x"}});
  const Unpacked result = unpacked("a.tar.gz", {{"work/homework.zip", inner},
                                                {"deep.zip", deep},
                                                {"h.tar.gz", harmful},
                                                {"c.cpp", "int c;"}});
  CHECK(result.refused == "");
  CHECK(result.files.size() == 2);
  CHECK(result.files.at("work/homework.zip/product.cpp") == "int a;");
  REQUIRE(result.notes.size() == 2);
  CHECK(result.notes[0] ==
        "deep.zip/i.zip in it was not read: it is an archive in an archive in an archive");
  CHECK(result.notes[1] == "h.tar.gz in it has a path that leads out of it: ../b.cpp");
}

TEST_CASE("archives: a bomb in an archive is the archive's") {
  const std::string zeros(20 << 20, '\0');
  const std::string bomb =
      tumble::test::archive_bytes("b.zip", std::vector<Entry>(14, {"zeros.txt", zeros}));
  CHECK(unpacked("a.zip", {{"b.zip", bomb}}).refused == "unpacks to more than 256 MB");
}

TEST_CASE("archives: names that no folder can have") {
  CHECK(unpacked("a.zip", {{"a.cpp", "x"}, {"a.cpp/b.cpp", "y"}}).refused ==
        "has both a file and a folder called a.cpp");
  CHECK(unpacked("a.tar.gz", {{"./a.cpp/b.cpp", "y"}, {"a.cpp", "x"}}).refused ==
        "has both a file and a folder called a.cpp");
  CHECK(unpacked("a.tar.gz", {{std::string(251, 'a') + ".cpp", "x"}})
            .refused.starts_with("has a name of 255 bytes: aaa"));
  std::string path;
  for (int i = 0; i < 30; ++i) path += std::string(99, 'a') + "/";
  CHECK(unpacked("a.tar.gz", {{path + "b.cpp", "x"}}).refused.starts_with("has a path of 3005"));
}

TEST_CASE("a class's download: what could be work is unpacked, of all else the names") {
  const WorkFolder folder;
  const std::string inner = tumble::test::archive_bytes("i.zip", {{"a.cpp", "x"}});
  write_archive(folder.path() / "all.zip", {{"Ann_1_assignsubmission_file_/a.cpp", "int a;"},
                                            {"Ben_2_assignsubmission_file_/i.zip", inner},
                                            {"Ben_2_assignsubmission_file_/report.pdf", "pdf"},
                                            {"Cem_3_assignsubmission_file_/a.cpp", "x"},
                                            {"Cem_3_assignsubmission_file_/a.cpp/b.cpp", "x"}});
  const auto to = folder.path() / "all";
  const std::vector<EntryLeftOut> left_out = unpack_class(folder.path() / "all.zip", to);
  REQUIRE(left_out.size() == 1);
  CHECK(left_out[0].path == "Cem_3_assignsubmission_file_/a.cpp/b.cpp");
  CHECK(left_out[0].is_work);
  CHECK(unpack(to / "Ben_2_assignsubmission_file_/i.zip").files.size() == 1);
  CHECK(std::filesystem::file_size(to / "Ann_1_assignsubmission_file_/a.cpp") == 6);
  CHECK(std::filesystem::file_size(to / "Ben_2_assignsubmission_file_/report.pdf") == 0);
  write_archive(folder.path() / "bad.tar.gz", {{"../../x.cpp", "x"}});
  CHECK_NOTHROW(unpack_class(folder.path() / "bad.tar.gz", to));  // said, and not written
  CHECK_FALSE(std::filesystem::exists(folder.path().parent_path() / "x.cpp"));
}
