/// @file
/// A class that several machines grade: each judges a shard, and merged they are what one machine
/// makes, byte for byte. What does not belong together is refused, and says why.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <regex>

#include "judge/class/shard.hpp"
#include "judge/class/sources.hpp"
#include "project/harness/command.hpp"
#include "project/judge/class/handed_in_class.hpp"

using namespace tumble;
using nlohmann::ordered_json;
using test::CommandResult;
namespace fs = std::filesystem;

namespace {

using Files = std::map<std::string, std::string>;

/// A dozen students, two folders of what they handed in, a roster: all that tables are made of.
struct Dozen {
  test::TemporaryFolder work;
  std::string settings = "course.json";

  Dozen() {
    const std::string file = "_assignsubmission_file_";
    std::string roster = "Identifier,Full name,Email address,Grade,Last modified (submission)\n";
    for (int i = 1; i <= 12; ++i) {
      const std::string name = "Student " + std::to_string(i), id = std::to_string(100 + i);
      roster += "Participant " + id + "," + name + ",s" + id + "@example.edu,,-\n";
      if (i == 12) continue;  // has not handed in
      const fs::path folder = work.path() / "first" / (name + "_" + id + file);
      test::write_files(folder, work_of(i));
    }
    test::write_file(work.path() / "worksheet.csv", roster);
    test::write_file(work.path() / "first" / "notes.txt", "nobody's");
    test::write_files(work.path() / "second" / ("Student 3_103" + file), test::both());
    test::write_files(work.path() / "second" / ("Zoe Late_199" + file), test::both());
    write_settings(settings, 8231, "");
  }
  static std::vector<test::Entry> work_of(int i) {
    switch (i % 4) {
      case 0:
        return {{"carry.cpp", test::carry()}, {"twice.cpp", "int x = ;\n"}};
      case 1:
        return test::both();
      case 2:
        return {{"twice.cpp", test::wrong_twice() + "// " + std::to_string(i) + "\n"}};
      default:
        return {{"work.zip", i == 3 ? "PK\x03\x04 and so on"
                                    : test::archive_bytes("w.zip", test::both("work/"))}};
    }
  }
  void write_settings(const std::string& file, int seed, const std::string& more) const {
    test::write_file(work.path() / file,
                     "{\"seed\": " + std::to_string(seed) + ", \"several\": \"best\"" + more + "}");
  }
  CommandResult run(const std::string& arguments) const {
    return test::run_command("cd '" + work.path().string() + "' && '" +
                             test::variable("TUMBLE_FIXTURE_JUDGE").string() + "' grade " +
                             arguments);
  }
  std::string inputs() const {
    return "first second --roster worksheet.csv --course " + settings + " ";
  }
  CommandResult grade(const std::string& out, const std::string& options = "") const {
    return run(inputs() + "--out " + out + " " + options);
  }
  /// Three shards, in folders a, b, c: judged once, for all tests.
  void judge_three() const {
    static const Dozen judged;
    for (const std::size_t k : {0u, 1u, 2u}) {
      const std::string folder(1, "abc"[k]);
      if (!fs::exists(judged.at(folder))) {
        const CommandResult result =
            judged.grade(folder, "--shard " + std::to_string(k + 1) + "/3");
        REQUIRE_MESSAGE(result.status == 0, result.output);
      }
      fs::copy(judged.at(folder), at(folder), fs::copy_options::recursive);
    }
  }
  fs::path at(const std::string& path) const { return work.path() / path; }
  ordered_json json_at(const std::string& path) const {
    return ordered_json::parse(test::text_of(at(path)));
  }
  void change(const std::string& path, const auto& how) const {
    ordered_json j = json_at(path);
    how(j);
    test::write_file(at(path), j.dump());
  }
  /// All files of a folder, but for the process that the lock names, where submissions were, and
  /// what shards leave.
  Files files_in(const std::string& folder) const {
    Files files;
    for (const auto& entry : fs::recursive_directory_iterator(at(folder)))
      if (const std::string name = entry.path().lexically_relative(at(folder)).string();
          entry.is_regular_file() && name != "lock" && name != "submissions.json" &&
          !name.starts_with("shards/"))
        files[name] = test::text_of(entry.path());
    return files;
  }
};

/// Without the times that judging took, and without the archive of what the other files say.
Files without_times(Files files) {
  static const std::regex times(R"re(("seconds": )[-+.e0-9]+|(time=")[.0-9]+|(\()[.0-9]+ s\))re");
  files.erase("feedback.zip");
  for (auto& [name, text] : files) text = std::regex_replace(text, times, "$1$2$3");
  return files;
}

void check_same(const Files& some, const Files& others) {
  for (const auto& file : some) {  // clang 14: no lambda of doctest's takes a binding
    CAPTURE(file.first);
    REQUIRE(others.contains(file.first));
    CHECK(others.at(file.first) == file.second);
  }
  CHECK(some.size() == others.size());
}

bool said_in(const CommandResult& result, const std::string& part) {
  return result.output.find(part) != std::string::npos;
}

/// Not a table, and nothing else that an instructor could take for the class's.
void check_no_table(const Dozen& dozen, const std::string& folder) {
  for (const char* name : {"grades.csv", "moodle.csv", "junit.xml", "feedback", "feedback.zip",
                           "identical.csv", "class.json"})
    CHECK_MESSAGE(!fs::exists(dozen.at(folder) / name), name);
}

}  // namespace

TEST_CASE("shards: a student's follows from the name, on every machine") {
  // FNV-1a, 64 bits, by another program.
  CHECK(judge::shard_number("ann", 10) == 2);
  CHECK(judge::shard_number("ann", 1000) == 922);
  CHECK(judge::shard_number("Ann Meyer_4711001", 10) == 6);
  CHECK(judge::shard_number("Cleo Ünal_4711003", 10) == 3);
  CHECK(judge::shard_number("Cleo Ünal_4711003", 3) == 1);
  std::array<int, 10> students{};
  for (int i = 0; i < 5000; ++i)
    ++students[judge::shard_number("s" + std::to_string(i), students.size()) - 1];
  CHECK(*std::min_element(students.begin(), students.end()) > 420);
  CHECK(*std::max_element(students.begin(), students.end()) < 580);
}

TEST_CASE("shards: what is none is refused, and what one is said") {
  const Dozen dozen;
  const std::pair<const char*, const char*> wrong[] = {
      {"0/10", "'0/10' is not a shard: 3/10 is the third of ten"},
      {"11/10", "'11/10': of 10 shards the last is 10/10"},
      {"3", "'3' is not a shard"},
      {"a/b", "'a/b' is not a shard"},
      {"3/", "'3/' is not a shard"},
      {"-1/3", "'-1/3' is not a shard"},
      {"1/3/2", "'1/3/2' is not a shard"},
      {"1/99999999999999999999", "is not a shard"},
      {"1/20000", "one of more than 10000 shards"}};
  for (const auto& each : wrong) {
    const char *text = each.first, *message = each.second;
    const CommandResult refused = dozen.grade("out", std::string("--shard=") + text);
    CHECK_MESSAGE(refused.status == 2, text);
    CHECK_MESSAGE(said_in(refused, message), refused.output);
    CHECK_FALSE(fs::exists(dozen.at("out")));
  }
  CHECK(said_in(dozen.run(""), "DIR is required"));
  CHECK(said_in(dozen.run("first --merge a"), "excludes"));
  test::write_file(dozen.at("none.json"), R"({"several": "best"})");
  const CommandResult seedless = dozen.run("first second --course none.json --out out --shard 1/3");
  CHECK(seedless.status == 2);
  CHECK_MESSAGE(said_in(seedless, "--shard needs a \"seed\""), seedless.output);
}

TEST_CASE("shards: merged they are what one machine makes, byte for byte") {
  const Dozen dozen;
  dozen.judge_three();
  std::size_t students = 0;
  for (const char* folder : {"a", "b", "c"}) {
    check_no_table(dozen, folder);
    for (const auto& entry : fs::directory_iterator(dozen.at(folder) / "students"))
      students += entry.is_regular_file() ? 1u : 0u;
  }
  CHECK(students == 12);  // eleven of the roster, and Zoe; each of them once
  const CommandResult merged = dozen.run("--merge a b c --out merged");
  REQUIRE_MESSAGE(merged.status == 0, merged.output);
  CHECK(said_in(merged, "tumble: 3 shards, 13 submissions"));  // one student's are two
  CHECK(said_in(merged, "not found on the roster:\n  Zoe Late_199"));
  CHECK(said_in(merged, "notes.txt"));
  const Files all = dozen.files_in("merged");
  CHECK(all.contains("moodle.csv"));
  CHECK(all.contains("feedback.zip"));

  REQUIRE(dozen.grade("one").status == 0);
  check_same(without_times(dozen.files_in("one")), without_times(all));

  // With the same records, so that times are the same too: every byte.
  fs::create_directories(dozen.at("again"));
  for (const char* kept : {"students", "sources", "attempts"})
    fs::copy(dozen.at("merged") / kept, dozen.at("again") / kept, fs::copy_options::recursive);
  const CommandResult again = dozen.grade("again");
  REQUIRE_MESSAGE(again.status == 0, again.output);
  check_same(dozen.files_in("again"), all);
  // And the other way round: what is merged is gone on with.
  REQUIRE(dozen.grade("merged").status == 0);
  check_same(dozen.files_in("merged"), all);
}

TEST_CASE("shards: beside each other in one folder") {
  const Dozen dozen;
  const CommandResult judged = test::run_command(
      "( cd '" + dozen.work.path().string() + "' && for k in 1 2 3; do '" +
      test::variable("TUMBLE_FIXTURE_JUDGE").string() + "' grade " + dozen.inputs() +
      "--jobs 1 --shard $k/3 & pids=\"$pids $!\"; done; for p in $pids; do wait $p || exit 9; "
      "done )");
  REQUIRE_MESSAGE(judged.status == 0, judged.output);
  for (const char* shard : {"1/3", "2/3", "3/3"})
    CHECK_MESSAGE(said_in(judged, std::string("shard ") + shard + ": "), judged.output);
  check_no_table(dozen, "grades");
  const CommandResult early =
      test::run_command("cd '" + dozen.work.path().string() + "' && '" +
                        test::variable("TUMBLE_FIXTURE_JUDGE").string() + "' report");
  CHECK(early.status == 2);
  CHECK_MESSAGE(said_in(early, "./tumble grade --merge grades"), early.output);
  const CommandResult merged = dozen.run("--merge grades");
  REQUIRE_MESSAGE(merged.status == 0, merged.output);
  REQUIRE(dozen.grade("one").status == 0);
  check_same(without_times(dozen.files_in("one")), without_times(dozen.files_in("grades")));
  const CommandResult other_cut = dozen.grade("grades", "--shard 1/4");
  CHECK(other_cut.status == 2);
  CHECK_MESSAGE(said_in(other_cut, "a shard of another division of the class"), other_cut.output);
}

TEST_CASE("shards: one of them is judged by one process at a time, all of a class by nobody else") {
  const Dozen dozen;
  const auto while_held = [&](const std::string& lock, const std::string& options) {
    return test::run_command("cd '" + dozen.work.path().string() + "' && mkdir -p out/shards && " +
                             "flock " + lock + " '" +
                             test::variable("TUMBLE_FIXTURE_JUDGE").string() + "' grade " +
                             dozen.inputs() + "--out out --student 'Student 2' " + options);
  };
  const std::string shard = std::to_string(judge::shard_number("Student 2_102", 2)),
                    other = shard == "1" ? "2" : "1";
  CHECK(said_in(while_held("-x out/lock", "--shard " + shard + "/2"),
                "another grading is at work in out"));
  CHECK(said_in(while_held("-s out/lock", ""), "another grading is at work in out"));
  const std::string own = "-x out/shards/" + shard + "-of-2.lock";
  CHECK(said_in(while_held(own, "--shard " + shard + "/2"), "of shard " + shard + "/2"));
  const CommandResult beside = while_held("-s out/lock", "--shard " + shard + "/2");
  CHECK_MESSAGE(beside.status == 0, beside.output);
  const CommandResult elsewhere = while_held("-s out/lock", "--shard " + other + "/2");
  CHECK(elsewhere.status == 2);
  CHECK_MESSAGE(
      said_in(elsewhere, "'Student 2' is in shard " + shard + "/2, not in " + other + "/2"),
      elsewhere.output);
}

TEST_CASE("shards: what does not belong together is not merged, and why is said") {
  const Dozen dozen;
  dozen.judge_three();
  const auto refused = [&](const std::string& folders, const std::string& message) {
    const CommandResult result = dozen.run("--merge " + folders + " --out merged");
    CHECK(result.status == 2);
    CHECK_MESSAGE(said_in(result, message), result.output);
    CHECK_FALSE(fs::exists(dozen.at("merged")));
  };
  // A copy of shard 2 with one thing changed, beside the others.
  const auto changed = [&](const auto& how) {
    fs::remove_all(dozen.at("x"));
    fs::copy(dozen.at("b"), dozen.at("x"), fs::copy_options::recursive);
    how();
  };
  const std::string manifest = "x/shards/2-of-3.json";
  const auto manifest_with = [&](const char* key, const auto& value) {
    changed([&] { dozen.change(manifest, [&](ordered_json& j) { j[key] = value; }); });
  };
  refused("a c", "a shard is missing: 2/3. Judge what is missing with --shard");
  refused("b", "shards are missing: 1/3, 3/3");
  refused("a nowhere", "nowhere is not a folder");
  refused("a first", "first holds no shard");
  manifest_with("settings", "{}");
  refused("a x c", "course.json is not the same in shard 1/3 (in a) and in shard 2/3 (in x)");
  manifest_with("seed", 7);
  refused("a x c", "shard 1/3 (in a) and shard 2/3 (in x) have different inputs");
  manifest_with("judges", ordered_json{{"01_crossing/carry", 1}, {"01_crossing/twice", 2}});
  refused("a x c", "come from different judges");
  manifest_with("of", 4);
  refused("a x c", "divide the class into different numbers of shards");
  changed([&] { test::write_file(dozen.at(manifest), "{"); });
  refused("a x c", "2-of-3.json cannot be understood");
  changed(
      [&] { dozen.change(manifest, [](ordered_json& j) { j["class"]["submissions"].erase(0); }); });
  refused("a x c",
          "Student 10_110 is in the class of shard 1/3 (in a) and not in that of shard "
          "2/3 (in x): give all shards the same submissions");
  fs::remove_all(dozen.at("x"));
  for (const char* folder : {"a", "b", "c"})
    for (const auto& entry : fs::directory_iterator(dozen.at(folder) / "shards"))
      if (entry.path().extension() == ".json")
        dozen.change(entry.path().string(), [](ordered_json& j) {
          j["judges"].erase("01_crossing/carry");
          j["judges"]["99_other/unit"] = 1;
        });
  refused("a b c", "is about another course: 99_other/unit");
}

TEST_CASE("shards: records that cannot be are named, and nothing is lost") {
  const Dozen dozen;
  dozen.judge_three();
  const std::string student = "Student 2_102";
  const std::size_t number = judge::shard_number(student, 3);
  const std::string own(1, "abc"[number - 1]), other(1, "abc"[number % 3]),
      record = own + "/students/" + student + ".json", sound = test::text_of(dozen.at(record));
  const auto refused = [&](const std::string& message) {
    const CommandResult result = dozen.run("--merge a b c --out merged");
    CHECK(result.status == 2);
    CHECK_MESSAGE(said_in(result, message), result.output);
    CHECK_FALSE(fs::exists(dozen.at("merged")));
    CHECK(said_in(dozen.run("--merge a b c --out merged"), message));  // it was not put away
  };
  const auto with = [&](const auto& how) {
    test::write_file(dozen.at(record), sound);
    dozen.change(record, how);
  };
  const std::string again = "judge shard " + std::to_string(number) + "/3 again";
  test::write_file(dozen.at(record), sound.substr(0, sound.size() / 2));
  refused("cannot be understood");
  refused(again);
  with([](ordered_json& j) { j["student"] = "ann"; });
  refused("is about ann, not about " + student);
  with([](ordered_json& j) { j["seed"] = 3; });
  refused("was judged with other inputs than its shard");
  with([](ordered_json& j) { j["units"][1]["judge"] = 3; });
  refused("has a verdict on 1.2 of another judge than its shard's");
  with([](ordered_json& j) { j["units"][1]["passed"] = true; });
  fs::copy_file(dozen.at(record), dozen.at(other + "/students/" + student + ".json"));
  test::write_file(dozen.at(record), sound);
  refused(student + " has two records, " + record + " and " + other + "/students/" + student +
          ".json, that differ; a student is in one shard, this one in " + std::to_string(number) +
          "/3");
  fs::remove(dozen.at(other + "/students/" + student + ".json"));
  // Judged again: the damaged one is put aside by who can make it anew.
  test::write_file(dozen.at(record), "{");
  REQUIRE(dozen.grade(own, "--shard " + std::to_string(number) + "/3").status == 0);
  CHECK(dozen.run("--merge a b c --out merged").status == 0);
}

TEST_CASE("shards: what was not judged to the end leaves grades open, and says whose") {
  const Dozen dozen;
  dozen.judge_three();
  REQUIRE(dozen.grade("one").status == 0);
  const std::string student = "Student 1_101";
  const std::string number = std::to_string(judge::shard_number(student, 3)),
                    own(1, "abc"[std::stoul(number) - 1]);
  fs::remove(dozen.at(own + "/students/" + student + ".json"));
  const CommandResult open = dozen.run("--merge a b c --out merged");
  CHECK(open.status == 1);
  CHECK_MESSAGE(said_in(open, "  shard " + number + "/3: 1 students"), open.output);
  CHECK(test::text_of(dozen.at("merged/moodle.csv"))
            .find("Participant 101,Student 1,s101@example.edu,,") != std::string::npos);
  REQUIRE(dozen.grade(own, "--shard " + number + "/3").status == 0);
  REQUIRE(dozen.run("--merge a b c --out merged").status == 0);
  check_same(without_times(dozen.files_in("one")), without_times(dozen.files_in("merged")));
}
