/// @file
/// Names of files and students: their order, what may reach a terminal, what a file may be called.
#include <doctest/doctest.h>

#include "judge/build/text_encoding.hpp"
#include "judge/build/utf16.hpp"
#include "judge/class/file_kinds.hpp"
#include "judge/class/file_names.hpp"
#include "judge/class/lms.hpp"
#include "project/harness/refusal.hpp"

using namespace tumble::judge;

TEST_CASE("names: the order that people expect") {
  struct InOrder {
    std::string less, more;
  };
  for (const InOrder& names :
       {InOrder{"v2", "v10"}, InOrder{"a", "B"}, InOrder{"hw1", "hw1-fixed"},
        InOrder{"draft", "final"}, InOrder{"007", "8"}, InOrder{"x", "x1"}}) {
    CHECK_MESSAGE(natural_less(names.less, names.more), names.less);
    CHECK_FALSE_MESSAGE(natural_less(names.more, names.less), names.less);
  }
  CHECK_FALSE(natural_less(std::string("a"), std::string("a")));
  CHECK(natural_less(std::string("A"), std::string("a")));  // never equal
}

TEST_CASE("names: kinds of files, whatever their case") {
  CHECK(archive_stem("Meyer.ZIP") == "Meyer");
  CHECK(archive_stem("a.b.tar.bz2") == "a.b");
  CHECK(archive_stem("a.7z") == "a");
  CHECK(archive_stem(".zip") == "");
  CHECK(archive_stem("zip") == "");
  for (const char* other : {"a.rar", "a.zipx", "a.jar", "a.cpio", "a.lzma", "a.tar.lzma", "a.Z"})
    CHECK_MESSAGE(foreign_archive_stem(other) == "a", other);
  CHECK(foreign_archive_stem("a.tar.gz") == "");
  CHECK(source_stem("x.CPP") == "x");
}

TEST_CASE("names: a student's is a file's, whatever it is") {
  CHECK(file_name_for("ann.b") == "ann.b");
  CHECK(file_name_for("Müller_4711") == "Müller_4711");
  const std::string longest(250, 'x');
  CHECK(file_name_for(longest).size() < 230);
  CHECK(file_name_for(longest) != file_name_for(longest + "y"));
  for (const char* odd : {"a/b", "a\nb", "\x1b[2J", "..", ".hidden"}) {
    const std::string name = file_name_for(odd);
    CHECK(name.find_first_of("/\n\x1b") == std::string::npos);
    CHECK_FALSE(name.starts_with("."));
  }
  CHECK(file_name_for("a/b") != file_name_for("a_b"));
  const std::string umlauts = file_name_for(std::string(179, 'x') + "ü");  // not cut in two
  CHECK(umlauts.starts_with(std::string(179, 'x') + "-"));
}

TEST_CASE("names: nothing reaches a terminal that it would obey") {
  CHECK(escaped("ann") == "ann");
  CHECK(escaped("a\x1b[2Jb\nc") == "a\\x1B[2Jb\\nc");
  CHECK(escaped("Müller") == "Müller");
  CHECK(escaped("a\xe2\x80\xae"
                "b") == "a\\xE2\\x80\\xAEb");  // which turns the direction of writing
}

TEST_CASE("UTF-16 becomes UTF-8") {
  using namespace std::string_literals;
  CHECK(utf8_of_utf16("int x;") == std::nullopt);
  CHECK(utf8_of_utf16("\xff\xfei\0\xe9\0"s) == "i\xc3\xa9");
  CHECK(utf8_of_utf16("\xfe\xff\0i\x20\xac"s) == "i\xe2\x82\xac");
  CHECK(utf8_of_utf16("\xff\xfe\x3d\xd8\x00\xde"s) == "\xf0\x9f\x98\x80");
  CHECK(utf8_of_utf16("\xff\xfe\x3d\xd8i\0"s) == "\xef\xbf\xbdi");  // half a character
  CHECK(utf8_of_utf16("\xff\xfe"s) == "");
}

TEST_CASE("Windows-1252 becomes UTF-8, byte by byte") {
  using namespace std::string_literals;
  CHECK(decoded("// Gr\xf6\xdf"
                "e")
            .text == "// Gr\u00f6\u00dfe");
  CHECK(decoded("\x80\x93x\x94\x81\xff").text == "\u20ac\u201cx\u201d\ufffd\u00ff");
  CHECK(decoded("\xf6").was == "Windows-1252");
  const DecodedText mixed = decoded(
      "Gr\u00f6\u00dfe, gr\xf6\xdf"
      "er");
  CHECK(mixed.text == "Gr\u00f6\u00dfe, gr\u00f6\u00dfer");
  CHECK(decoded("Gr\u00f6\u00dfe").was == "");
  CHECK(decoded("\xff\xfei\0"s).was == "UTF-16");
  CHECK(decoded("\xf6\0"s).text == "\xf6\0"s);  // no text
}

TEST_CASE("platforms: what an entry of a download says") {
  const auto moodle = moodle_entry("Ann van Meyer_4711001_assignsubmission_file_");
  REQUIRE(moodle);
  CHECK(moodle->name == "Ann van Meyer");
  CHECK(moodle->id == "4711001");
  CHECK(moodle->file == "");
  CHECK(moodle->key() == "Ann van Meyer_4711001");
  CHECK(moodle_entry("A_1_assignsubmission_file")->file == "");  // Moodle 4.1
  CHECK(moodle_entry("A_1_assignsubmission_file_b_c.cpp")->file == "b_c.cpp");
  CHECK(moodle_entry("A_1_assignsubmission_onlinetext_")->is_text);
  CHECK(moodle_entry("A_1_assignsubmission_comments_")->kind == "comments");
  CHECK(moodle_entry("A_1_assignsubmission_comments_")->key() == "A_1");
  CHECK_FALSE(moodle_entry("ann").has_value());

  const auto canvas = canvas_entry("doejane_LATE_12345_67890_rk4_step-1.cpp");
  REQUIRE(canvas);
  CHECK(canvas->name == "doejane");
  CHECK(canvas->late);
  CHECK(canvas->id == "12345");
  CHECK(canvas->attachment == "67890");
  CHECK(canvas->file == "rk4_step-1.cpp");
  CHECK_FALSE(canvas_entry("doejane_12345_67890_a.cpp")->late);
  CHECK(canvas_entry("anon_aB3xY_67890_a.cpp")->id == "aB3xY");
  CHECK(canvas_entry("doejane_12345_text.html")->is_text);
  for (const char* other : {"euler_step.cpp", "a_1_b.cpp", "notes_2026_final.txt"})
    CHECK_FALSE_MESSAGE(canvas_entry(other).has_value(), other);
  CHECK_REFUSED(lms_named("blackboard"), "moodle, canvas, gradescope, folders");
}
