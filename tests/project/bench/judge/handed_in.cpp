#include "project/bench/judge/handed_in.hpp"

#include <algorithm>
#include <cstdio>

#include "project/bench/judge/mistakes.hpp"
#include "project/judge/attacks/submission.hpp"
#include "project/judge/class/archives.hpp"
#include "support/text_file.hpp"

namespace tumble::bench {

namespace {

using judge::Course;
using judge::Unit;
using test::Random;

/// Judging one of these takes as long as the judge's patience: seconds. In a class they are rare.
bool takes_seconds(const test::Submission& attack) {
  return std::any_of(
      attack.verdicts.begin(), attack.verdicts.end(), [](const std::string& verdict) {
        return verdict == "hung" || verdict == "flooded" || verdict == "too expensive to compile";
      });
}

/// The hostile files, and those of them that are slow.
struct Hostile {
  std::vector<std::string> quick, slow;

  explicit Hostile(const Attacks& attacks) {
    ::setenv("TUMBLE_ROOT", attacks.root.c_str(), 1);  // where read_submission() looks
    for (const test::Submission& each : test::submissions_in(attacks.folder))
      (takes_seconds(each) ? slow : quick)
          .push_back(test::replaced(each.text, "@OPEN@", attacks.writable.string()));
  }
};

/// Files that are no source.
std::string odd_text(Random& random) {
  switch (pick(random, 4)) {
    case 0:
      return "";
    case 1:
      return "\n \n";
    case 2:
      return std::string(
          "\x7f"
          "ELF\0\0\xff",
          7);
    default:
      return "// I ran out of time, sorry.\n";
  }
}

Kind kind_of_work(Random& random) {
  const double x = random.uniform(0, 1);
  if (x < 0.75) return Kind::solution;
  if (x < 0.95) return Kind::mistake;
  return x < 0.99 ? Kind::no_program : Kind::odd;
}

/// Each attack is made for 4.1.
constexpr const char* attacked = "04_quaternions/product";

class ClassMaker {
 public:
  ClassMaker(const Course& course, const std::vector<Unit>& given, const Attacks& attacks,
             const fs::path& place, std::uint64_t seed)
      : course_(course), units_(given), hostile_(attacks), random_(seed) {
    all_.submissions = place / "submissions";
    all_.sources = place / "sources";
  }

  HandedIn make(std::size_t students) {
    for (std::size_t i = 0; i < students; ++i) add_student(i, students);
    return std::move(all_);
  }

 private:
  void add_student(std::size_t number, std::size_t of) {
    char name[32];
    std::snprintf(name, sizeof name, "s%04zu", number + 1);
    Student student{name, {}, number % 5 == 4};
    const bool hostile = number % 8 == 3;
    const bool slow = number % 64 == 3 && of >= 64;
    const std::size_t units = units_.size();
    const std::size_t worked_on =
        number % 3 < 2 ? units : units / 4 + pick(random_, units - units / 4);
    std::vector<test::Entry> files;
    for (std::size_t i = 0; i < units; ++i) {
      const Unit& unit = units_[i];
      Kind kind = i < worked_on ? kind_of_work(random_) : Kind::untouched;
      if (hostile && unit.id() == attacked) kind = Kind::attack;
      student.files[unit.id()] = kind;
      files.push_back({unit.id() + ".cpp", text_of(kind, unit, student.name, slow)});
    }
    write(student, files);
    all_.students.push_back(std::move(student));
  }

  std::string text_of(Kind kind, const Unit& unit, const std::string& student, bool slow) {
    const std::string mine = "// " + student + ", " + unit.number + "\n";
    const auto solution = [&] { return support::read_text(course_.solution(unit)); };
    switch (kind) {
      case Kind::untouched:
        return support::read_text(course_.exercise(unit));
      case Kind::solution:
        return mine + solution();
      case Kind::mistake:
        return mine + with_mistake(solution(), random_);
      case Kind::no_program:
        return mine + that_does_not_compile(solution(), random_);
      case Kind::attack: {
        const std::vector<std::string>& attacks = slow ? hostile_.slow : hostile_.quick;
        return attacks[pick(random_, attacks.size())] + mine;
      }
      case Kind::odd:
        break;
    }
    return odd_text(random_);
  }

  void write(const Student& student, const std::vector<test::Entry>& files) {
    for (const test::Entry& file : files) {
      const fs::path source = all_.sources / student.name / file.path;
      fs::create_directories(source.parent_path());
      support::write_text(source, file.content);
    }
    fs::create_directories(all_.submissions);
    if (student.as_archive)
      test::write_archive(all_.submissions / (student.name + ".zip"), files);
    else
      fs::copy(all_.sources / student.name, all_.submissions / student.name,
               fs::copy_options::recursive);
  }

  const Course& course_;
  const std::vector<Unit>& units_;
  Hostile hostile_;
  Random random_;
  HandedIn all_;
};

}  // namespace

std::string name_of(Kind kind) {
  switch (kind) {
    case Kind::solution:
      return "solution";
    case Kind::mistake:
      return "solution with a mistake";
    case Kind::untouched:
      return "untouched stub";
    case Kind::no_program:
      return "does not compile";
    case Kind::attack:
      return "attack";
    case Kind::odd:
      return "empty, or no source";
  }
  return "";
}

HandedIn hand_in(const Course& course, const std::vector<Unit>& units, const Attacks& attacks,
                 const fs::path& place, std::size_t students, std::uint64_t seed) {
  return ClassMaker(course, units, attacks, place, seed).make(students);
}

}  // namespace tumble::bench
