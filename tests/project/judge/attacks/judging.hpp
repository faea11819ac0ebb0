#pragma once
/// @file
/// Hands a folder of files in to the judge, as a class's script would, and looks at what it says
/// and at what it leaves behind.

#include <stdlib.h>
#include <unistd.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "submission.hpp"

namespace tumble::test {

/// A folder of its own for one run of the judge; every user may pass through, as in /tmp.
class Place {
 public:
  Place() {
    std::string name = fs::temp_directory_path() / "tumble-attack-XXXXXX";
    require(::mkdtemp(name.data()) != nullptr, "cannot make ", name);
    path_ = name;
    const auto everybody = fs::perms::owner_all | fs::perms::group_exec | fs::perms::others_exec;
    fs::permissions(path_, everybody);
    for (const fs::path& folder : {files(), temporary(), open()}) {
      fs::create_directory(folder);
      fs::permissions(folder, everybody);
    }
    fs::permissions(open(), fs::perms::all);
  }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;
  ~Place() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }

  const fs::path& path() const { return path_; }
  /// What is handed in.
  fs::path files() const { return path_ / "files"; }
  /// The judge's folder for temporary files.
  fs::path temporary() const { return path_ / "temporary"; }
  /// Where every user may write: what an attack leaves there, it leaves for others.
  fs::path open() const { return path_ / "open"; }

 private:
  fs::path path_;
};

/// What the judge has made of one folder of files.
struct Judgement {
  int status = 0;
  double seconds = 0;
  std::string output;          ///< on the terminal
  std::uintmax_t printed = 0;  ///< bytes, if more than `output` holds
  std::string json_text;
  nlohmann::json product;                ///< its verdict on 4.1 …
  nlohmann::json inverse;                ///< … and on 4.2, which was handed in beside it
  std::vector<std::string> left_behind;  ///< folders and processes
};

namespace detail {

/// Processes that run from or in `folder`, or that name it on their command line.
inline std::vector<std::string> processes_in(const fs::path& folder) {
  std::vector<std::string> found;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc", ignored)) {
    const std::string pid = entry.path().filename().string();
    if (pid.find_first_not_of("0123456789") != std::string::npos) continue;
    const std::string place = folder.string();
    std::string traces = text_of(entry.path() / "cmdline", 1 << 16);
    for (const char* link : {"exe", "cwd"})
      traces += fs::read_symlink(entry.path() / link, ignored).string();
    if (traces.find(place) != std::string::npos) found.push_back("process " + pid);
  }
  return found;
}

inline nlohmann::json unit_of(const nlohmann::json& results, const std::string& number) {
  if (!results.is_object()) return {};
  for (const nlohmann::json& unit : results.value("units", nlohmann::json::array()))
    if (unit.value("number", "") == number) return unit;
  return {};
}

/// A process that was killed still takes a moment to give gigabytes back; one that lives on does
/// so for longer than that.
inline std::vector<std::string> processes_left_in(const fs::path& folder) {
  std::vector<std::string> found = processes_in(folder);
  for (int tenths = 0; !found.empty() && tenths < 50; ++tenths) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    found = processes_in(folder);
  }
  return found;
}

inline std::vector<std::string> left_behind(const Place& place) {
  std::vector<std::string> things = processes_left_in(place.temporary());
  for (const fs::path& folder : {place.temporary(), place.open()})
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      things.push_back(entry.path().string());
  return things;
}

}  // namespace detail

/// Seconds that no submission may take: some wait for the judge's own limits, on a busy machine.
constexpr double most_seconds = 150;

/// Judges chapter 4 with the files in `place`.
/// @param options  further ones of `check`
inline Judgement judge(const Place& place, const std::string& options = "--once") {
  const fs::path json = place.path() / "results.json", output = place.path() / "output";
  const std::string command = "cd " + place.path().string() +
                              " && TMPDIR=" + place.temporary().string() + " timeout -k 1 300 '" +
                              variable("TUMBLE_JUDGE").string() + "' check 4 --from " +
                              place.files().string() + " --json " + json.string() + " --seed 1 " +
                              options + " > " + output.string() + " 2>&1 < /dev/null";
  Judgement judgement;
  const auto start = std::chrono::steady_clock::now();
  judgement.status = std::system(command.c_str());
  judgement.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  judgement.output = text_of(output);
  judgement.printed = fs::file_size(output);
  judgement.json_text = text_of(json);
  const auto results = nlohmann::json::parse(judgement.json_text, nullptr, false);
  judgement.product = detail::unit_of(results, "4.1");
  judgement.inverse = detail::unit_of(results, "4.2");
  judgement.left_behind = detail::left_behind(place);
  return judgement;
}

/// The solution of another unit is handed in beside the attack: its mark must not suffer.
inline void hand_in_a_right_inverse(const Place& place) {
  fs::copy_file(root() / "solutions/04_quaternions/inverse.cpp", place.files() / "inverse.cpp");
}

/// The verdict in words; "no verdict" if the judge gave none.
inline std::string summary_of(const nlohmann::json& unit) {
  return unit.is_object() ? unit.value("summary", "no verdict") : "no verdict";
}

inline bool passed(const nlohmann::json& unit) {
  return unit.is_object() && unit.value("passed", false);
}

inline Judgement judge_once(const Submission& submission) {
  const Place place;
  std::ofstream(place.files() / "product.cpp", std::ios::binary)
      << replaced(submission.text, "@OPEN@", place.open().string());
  hand_in_a_right_inverse(place);
  // Those that attack the second run, with sanitizers, have it; the others only cost its time.
  return judge(place, submission.name.starts_with("again_") ? "" : "--once");
}

/// On a busy machine the judge may say that a program did not get the processor: then it is asked
/// again, as it asks people to.
inline Judgement judge(const Submission& submission) {
  Judgement judgement = judge_once(submission);
  const auto is_machine = [&] {
    return judgement.output.find("did not get the processor") != std::string::npos;
  };
  for (int again = 0; again < 3 && is_machine(); ++again) judgement = judge_once(submission);
  return judgement;
}

}  // namespace tumble::test
