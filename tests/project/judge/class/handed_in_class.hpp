#pragma once
/// @file
/// A class as it hands in through different systems, on the course in tests/project/judge/course:
/// what each student's submission looks like, and what it is worth.

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "project/judge/attacks/submission.hpp"
#include "project/judge/class/archives.hpp"

namespace tumble::test {

namespace fs = std::filesystem;

/// What a row of the table should say.
struct ExpectedRow {
  std::string points;
  std::string note;  ///< or a part of it
};
using ExpectedRows = std::map<std::string, ExpectedRow>;

inline std::string fixture_solution(const std::string& unit) {
  return text_of(variable("TUMBLE_FIXTURE") / "solutions/01_crossing" / (unit + ".cpp"));
}

inline std::string carry() { return fixture_solution("carry"); }
inline std::string twice() { return fixture_solution("twice"); }

/// A mistake that the judge knows by name.
inline std::string wrong_twice() {
  return "#include \"contract.hpp\"\nnamespace crossing {\n"
         "Eigen::VectorXd twice(const Rhs& f, double t, const Eigen::VectorXd& y, double) {\n"
         "  return f(t, f(t, y));\n}\n}\n";
}

/// Both files, right.
inline std::vector<Entry> both(const std::string& folder = "") {
  return {{folder + "carry.cpp", carry()}, {folder + "twice.cpp", twice()}};
}

inline void write_file(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

inline void write_files(const fs::path& folder, const std::vector<Entry>& files) {
  for (const Entry& file : files) write_file(folder / file.path, file.content);
}

/// Folders and archives, as they come by mail or from a shared disk.
inline ExpectedRows hand_in_folders(const fs::path& to) {
  write_files(to / "ann", both("exercises/01_crossing/"));
  write_archive(to / "Ben.ZIP", both());
  write_archive(to / "cem.tar.bz2", both("work/"));
  write_archive(to / "dan.7z", both());
  write_file(to / "eve.rar", "Rar!\x1a\x07");
  write_files(to / "fay", {{"Carry.CPP", carry()}, {"TWICE.cpp.txt", twice()}});
  write_files(to / "gus", {{"carry (1).cpp", carry()}, {"twice-1.cpp", twice()}});
  write_files(to / "hal", {{"carry.cpp", utf16(carry())}, {"twice.cpp", utf16(twice())}});
  write_file(to / "ida/homework1.zip", archive_bytes("h.zip", both("homework1/")));
  write_archive(to / "jon.zip", {{"hand-in/inner.tar.gz", archive_bytes("i.tar.gz", both())}});
  write_files(to / "kim", {{"homework1.docx", "PK"}, {"main.cpp", "int main() {}\n"}});
  write_files(to / "leo", {{"v1/twice.cpp", twice()},
                           {"v2/twice.cpp", wrong_twice()},
                           {"v10/twice.cpp", twice() + "// at last\n"}});
  write_archive(to / "mia.zip", {{"twice.cpp", twice()}, {"twice.cpp/a.cpp", "x"}});
  write_archive(to / "ned.tar.gz", {{std::string(260, 'n') + ".cpp", "x"}});
  fs::create_directories(to / "oda");
  write_files(to / "\x1b[2Jpia\nqux", both());
  write_files(to / std::string(250, 'r'), both());
  write_file(to / "sue/broken.zip", "PK\x03\x04 and so on");
  write_file(to / "uma/twice.cpp", twice());
  fs::create_symlink("carry.cpp", to / "uma/carry.cpp");
  write_file(to / "list of names.txt", "ann, ben\n");
  fs::create_symlink("/etc", to / "tom");
  write_file(to / ".git/config", "x");
  return {{"ann", {"2", ""}},
          {"Ben", {"2", ""}},
          {"cem", {"2", ""}},
          {"dan", {"2", ""}},
          {"eve", {"0", "eve.rar, an archive that cannot be read here"}},
          {"fay", {"2", ""}},
          {"gus", {"2", ""}},
          {"hal", {"2", "carry.cpp is UTF-16: converted to UTF-8"}},
          {"ida", {"2", ""}},
          {"jon", {"2", ""}},
          {"kim", {"0", "no exercise found in it; it holds homework1.docx, main.cpp"}},
          {"leo", {"1", "3 files for 1.2: counted v10/twice.cpp"}},
          {"mia", {"0", "has both a file and a folder called twice.cpp"}},
          {"ned", {"0", "has a name of 264 bytes"}},
          {"oda", {"0", "no exercise found in it; it is empty"}},
          {"\x1b[2Jpia\nqux", {"2", ""}},
          {std::string(250, 'r'), {"2", ""}},
          {"sue", {"0", "has broken.zip in it, which is damaged"}},
          {"uma", {"1", "1.1 is refused: carry.cpp is a symbolic link, not a file"}}};
}

/// Moodle's "Download all submissions", unpacked.
inline ExpectedRows hand_in_moodle(const fs::path& to) {
  const std::string file = "_assignsubmission_file_", typed = "_assignsubmission_onlinetext_";
  write_files(to / ("Ann Meyer_4711001" + file), both());
  write_file(to / ("Ben Kim_4711002" + file) / "homework1.zip",
             archive_bytes("h.zip", both("homework1/exercises/01_crossing/")));
  write_file(to / ("Ben Kim_4711002" + typed) / "onlinetext.html", "<p>see my zip</p>");
  write_file(to / ("Cleo Ünal_4711003" + file) / "twice.cpp", wrong_twice());
  write_file(to / ("Cleo Ünal_4711003" + file) / "carry.cpp", carry());
  write_file(to / ("Dan Li_4711004" + typed) / "onlinetext.html", "<p>I was ill</p>");
  // Without a folder of her own, as in older downloads; her file in the plugin's folder counts.
  write_file(to / ("Eve Roe_4711005" + file + "carry.cpp"), carry());
  write_file(to / "Eve Roe_4711005_assignsubmission_comments_" / "twice.cpp", twice());
  return {{"Ann Meyer_4711001", {"2", ""}},
          {"Ben Kim_4711002", {"2", "a text was typed into Moodle: it is not graded"}},
          {"Cleo Ünal_4711003", {"1", ""}},
          {"Dan Li_4711004", {"0", "no exercise found in it; it holds typed text/onlinetext.html"}},
          {"Eve Roe_4711005",
           {"2",
            "Moodle's \"comments\" are there. We grade files of exercises in them; we do not grade "
            "texts."}}};
}

/// Canvas's "Download Submissions", unpacked: one flat folder.
inline ExpectedRows hand_in_canvas(const fs::path& to) {
  write_file(to / "doejane_12345_67890_carry.cpp", carry());
  write_file(to / "doejane_12345_67891_twice-1.cpp", twice());
  write_file(to / "roebob_LATE_12346_67892_twice.cpp", twice());
  write_file(to / "poesue_12347_67893_homework.zip", archive_bytes("h.zip", both("sue/")));
  write_file(to / "limin_12348_text.html", "<p>later</p>");
  return {{"doejane_12345", {"2", ""}},
          {"roebob_12346", {"1", ""}},
          {"poesue_12347", {"2", ""}},
          {"limin_12348", {"0", "a text was typed into Canvas"}}};
}

/// Gradescope's "Download Submissions", unpacked.
inline ExpectedRows hand_in_gradescope(const fs::path& to) {
  write_files(to / "submission_1001", both());
  write_files(to / "submission_1002", {{"twice.cpp", twice()}});
  write_files(to / "submission_1009", both());
  write_file(to / "submission_metadata.yml",
             "---\n"
             "submission_1001:\n"
             "  :submitters:\n"
             "  - :name: Jane Doe\n"
             "    :sid: '12345'\n"
             "    :email: jane@example.edu\n"
             "  :created_at: 2026-11-12 22:43:59.184049000 Z\n"
             "  :score: 1.0\n"
             "  :results:\n"
             "    tests:\n"
             "    - :name: not a student\n"
             "submission_1002:\n"
             "  :submitters:\n"
             "  - :name: 'Bob O''Roe'\n"
             "    :sid: '12346'\n"
             "    :email: bob@example.edu\n"
             "  - :name: Sue Poe\n"
             "    :sid:\n"
             "    :email: sue@example.edu\n"
             "  :created_at: 2026-11-13 09:00:00.000000000 Z\n"
             "submission_1003:\n"
             "  :submitters:\n"
             "  - :name: Min Li\n"
             "    :email: min@example.edu\n");
  return {
      {"jane@example.edu", {"2", ""}},
      {"bob@example.edu", {"1", "handed in by 2 together"}},
      {"sue@example.edu", {"1", "handed in by 2 together"}},
      {"min@example.edu",
       {"0", "not judged: submission_1003 is named in submission_metadata.yml, but is not there"}},
      {"submission_1009", {"2", ""}}};
}

/// Clones of the students' repositories.
inline ExpectedRows hand_in_clones(const fs::path& to) {
  for (const char* student : {"hw-ann", "hw-ben"}) {
    write_files(to / student, both("exercises/01_crossing/"));
    write_file(to / student / ".git/config", "[core]\n");
    write_file(to / student / "build/carry.cpp", "not theirs");
    write_file(to / student / "tests/01_crossing/twice.cpp", "a spec");
  }
  return {{"hw-ann", {"2", ""}}, {"hw-ben", {"2", ""}}};
}

}  // namespace tumble::test
