/// @file
/// ./tumble mine: an engine of a student's functions, good, incomplete, wrong and broken.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "project/harness/command.hpp"

using tumble::test::CommandResult;
using tumble::test::run_command;
namespace fs = std::filesystem;

namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  tumble::require(value != nullptr, "ctest sets ", name);
  return value;
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A student who has done everything, until something is put in its place.
class Student {
 public:
  Student() {
    std::string name = fs::temp_directory_path() / "tumble-mine-XXXXXX";
    tumble::require(::mkdtemp(name.data()) != nullptr, "cannot make ", name);
    path_ = name;
    fs::copy(fs::path(variable("TUMBLE_ROOT")) / "solutions", files(), fs::copy_options::recursive);
  }
  Student(const Student&) = delete;
  Student& operator=(const Student&) = delete;
  ~Student() { fs::remove_all(path_); }

  fs::path files() const { return path_ / "files"; }
  std::string figure() const { return text_of(path_ / "mine.svg"); }
  nlohmann::json numbers() const { return nlohmann::json::parse(text_of(path_ / "mine.json")); }

  /// Another text for one of the files, `from` there replaced by `to`.
  void change(const std::string& file, const std::string& from, const std::string& to) const {
    std::string text = text_of(files() / file);
    const auto at = text.find(from);
    tumble::require(at != std::string::npos, file, " does not contain ", from);
    std::ofstream(files() / file) << text.replace(at, from.size(), to);
  }

  CommandResult mine(const std::string& options = "") const { return from(files(), options); }
  CommandResult from(const fs::path& folder, const std::string& options) const {
    return run_command("timeout 200 '" + variable("TUMBLE_JUDGE") + "' mine --from '" +
                       folder.string() + "' --svg '" + (path_ / "mine.svg").string() +
                       "' --json '" + (path_ / "mine.json").string() + "' " + options);
  }

 private:
  fs::path path_;
};

const fs::path stubs = fs::path(variable("TUMBLE_ROOT")) / "exercises";

/// The student's curve of this name on a problem.
nlohmann::json curve_of(const nlohmann::json& numbers, std::size_t problem,
                        const std::string& name) {
  for (const nlohmann::json& curve : numbers.at("problems").at(problem).at("curves"))
    if (curve.at("from") == "student" && curve.at("name") == name) return curve;
  return {};
}

}  // namespace

TEST_CASE("the solutions make an engine whose errors fall as their methods promise") {
  const Student student;
  const CommandResult result = student.mine();
  CHECK_MESSAGE(result.status == 0, result.output);
  CHECK(contains(result.output, "An engine of 29 functions, all of them yours."));
  const nlohmann::json numbers = student.numbers();
  CHECK(numbers.at("right") == true);
  REQUIRE(numbers.at("problems").size() == 3);
  const std::pair<const char*, double> orders[] = {{"Euler", 1}, {"midpoint", 2}, {"RK4", 4}};
  for (std::size_t problem = 0; problem < 3; ++problem) {
    // A thousand faces and more, each of their sums rounded: √1776 · 2⁻⁵³, with room.
    CHECK(numbers.at("problems")[problem].at("mass").at("error") < 1e-13);
    for (const auto& each : orders) {
      const double observed = curve_of(numbers, problem, each.first).at("order");
      CHECK_MESSAGE(std::abs(observed - each.second) < 0.5, each.first, " has the order ",
                    observed);
    }
  }
  const nlohmann::json closed_form = curve_of(numbers, 2, "closed form");
  CHECK(closed_form.at("points")[0].at("error") < 1e-12);
  for (const char* part :
       {"your RK4", "library DOP853", "your die", "All functions of this engine are yours."})
    CHECK(contains(student.figure(), part));
}

TEST_CASE("the solutions let a die bounce: it is as late as its tolerance makes it") {
  const Student student;
  const CommandResult result = student.mine();
  CHECK(contains(result.output, "A die falls onto a table without friction, with e = 0.6."));
  const nlohmann::json die = student.numbers().at("die");
  CHECK(die.at("right") == true);
  REQUIRE(die.at("impacts").size() == 12);
  // It touches at 1e-11 m, and comes down with 1 m/s and more.
  CHECK(std::abs(die.at("impacts")[0].at("late").get<double>()) < 1e-11);
  double before = 1;
  for (const nlohmann::json& impact : die.at("impacts")) {
    CHECK(impact.at("energy_left") < before);
    before = impact.at("energy_left");
  }
}

TEST_CASE("an engine runs without the functions of the die, which are named") {
  const Student student;
  fs::remove(student.files() / "11_when_bodies_meet/collide.cpp");
  student.change("11_when_bodies_meet/separation.cpp", "return", "retrun");
  const CommandResult result = student.mine();
  CHECK_MESSAGE(result.status == 0, result.output);
  for (const char* part : {"An engine of 25 functions, all of them yours.",
                           "To drop a die onto a table, we also need these functions of yours",
                           "11.2  separation   does not compile",
                           "11.5  collide      there is no file", "Next:  ./tumble check 11.2"})
    CHECK_MESSAGE(contains(result.output, part), result.output);
  const nlohmann::json die = student.numbers().at("die");
  CHECK_FALSE(die.contains("impacts"));
  REQUIRE(die.at("waits_for").size() == 2);
  CHECK(die.at("waits_for")[0].at("number") == "11.2");
  CHECK(die.at("waits_for")[1].at("missing") == "there is no file");
}

TEST_CASE("an engine runs where only the die lacks a helper, which is named") {
  const Student student;
  student.change("11_when_bodies_meet/collide.cpp", "const double u_n = u.dot(n);",
                 "double helped(double);\n  const double u_n = helped(u.dot(n));");
  const CommandResult result = student.mine();
  CHECK(result.status == 1);
  for (const char* part :
       {"An engine of 25 functions, all of them yours.", "your RK4",
        "The die: your functions of chapter 11 use what is not there", "helped", "The figure: "})
    CHECK_MESSAGE(contains(result.output, part), result.output);
  CHECK(curve_of(student.numbers(), 0, "RK4").at("right") == true);
}

TEST_CASE("a die that bounces wrongly: from which impact on, and which law it breaks") {
  const Student student;
  student.change("11_when_bodies_meet/contact_matrix.cpp", "Identity() / body.mass", "Identity()");
  const CommandResult result = student.mine();
  CHECK(result.status == 1);
  for (const char* part : {"The die: impact 2 comes", "s too late", "Impact 1 leaves",
                           "where 72 % is right", "Broken: the energy, which rises by",
                           "✗ 11.4 contact_matrix  wrong", "Next:  ./tumble check 11.4"})
    CHECK_MESSAGE(contains(result.output, part), result.output);
  CHECK(student.numbers().at("die").at("right") == false);
  CHECK(curve_of(student.numbers(), 0, "RK4").at("right") == true);
}

TEST_CASE("a die that sinks, and one that is pushed aside") {
  const Student student;
  student.change("11_when_bodies_meet/first_contact.cpp", "distance / speed", "0.001");
  const std::string sunk = student.mine().output;
  CHECK_MESSAGE(contains(sunk, "The die: threw: at 0.17"), sunk);
  CHECK_MESSAGE(contains(sunk, " s the die is inside the table"), sunk);
  const Student other;
  other.change("11_when_bodies_meet/collide.cpp", "n.dot(K * n) * n",
               "n.dot(K * n) * (n + Eigen::Vector3d(0.01, 0, 0))");
  CHECK(contains(other.mine().output, "Broken: P along the table and L about its normal"));
}

TEST_CASE("untouched stubs: all that is missing is named at once") {
  const Student student;
  const CommandResult result = student.from(stubs, "");
  CHECK(result.status == 1);
  for (const char* part :
       {"25 of yours are not there yet", "4.8   quaternion_dot", "exercises/09_rigid_body/dydt.cpp",
        "./tumble check 1.3", "./tumble mine --fill"})
    CHECK_MESSAGE(contains(result.output, part), result.output);
  CHECK(student.numbers().at("parts").size() == 25);
}

TEST_CASE("--fill: the solutions stand in for exactly what is missing, and this is said") {
  const Student student;
  const CommandResult result = student.from(stubs, "--fill");
  CHECK_MESSAGE(result.status == 0, result.output);
  CHECK(contains(result.output, "0 of them yours. From the solutions: 1.3 euler_step, 1.4"));
  CHECK(contains(student.figure(), "Not yours, but from the solutions: 1.3 euler_step"));
}

TEST_CASE("what does not compile, lacks its function, is not there or not finished") {
  const Student student;
  student.change("05_momentum/torque.cpp", "return", "retrun");
  student.change("04_quaternions/quaternion_dot.cpp", "const Quaternion& q", "Quaternion q");
  student.change("01_particles/rk4_step.cpp", "  return", "  throw NotImplemented{};\n  return");
  fs::remove(student.files() / "09_rigid_body/pack.cpp");
  const CommandResult result = student.mine();
  CHECK(result.status == 1);
  for (const char* part :
       {"4 of yours are not there yet", "torque           does not compile",
        "torque.cpp:9:", "quaternion_dot   wrong signature", "pack             there is no file",
        "rk4_step         still throws NotImplemented"})
    CHECK_MESSAGE(contains(result.output, part), result.output);
}

TEST_CASE("an engine that runs and is wrong: the law that it breaks, and the unit") {
  const Student student;
  student.change("04_quaternions/quaternion_dot.cpp", "product(spin, q)", "product(q, spin)");
  const CommandResult result = student.mine();
  CHECK(result.status == 1);
  for (const char* part :
       {"No method converges to the true motion with smaller steps", "Broken: the energy",
        "as if ω were in body axes", "✗ 4.8 quaternion_dot  wrong", "Next:  ./tumble check 4.8"})
    CHECK_MESSAGE(contains(result.output, part), result.output);
  const nlohmann::json numbers = student.numbers();
  CHECK(numbers.at("right") == false);
  CHECK(numbers.at("problems")[0].at("broken_by").at("energy") > 1e-3);
  CHECK(curve_of(numbers, 0, "RK4").at("points").back().at("error") > 1e-3);
}

TEST_CASE("crashes, endless loops and no numbers: named, and everything else goes on") {
  const Student student;
  student.change("01_particles/euler_step.cpp", "return",
                 "*static_cast<volatile int*>(nullptr) = 1;\n  return");
  student.change("01_particles/midpoint_step.cpp", "return", "return 0.0 / 0.0 * y;\n  return");
  student.change("10_only_what_a_scene_needs/energy_drift.cpp", "if (states.empty())",
                 "for (volatile int i = 0; i >= 0; i = 1) {}\n  if (states.empty())");
  student.change("11_when_bodies_meet/collide.cpp", "const double u_n",
                 "for (volatile int i = 0; i >= 0; i = 1) {}\n  const double u_n");
  const CommandResult result = student.mine();
  CHECK(result.status == 1);
  for (const char* part :
       {"1.3 euler_step, or what it steps: crashed: SIGSEGV", "The die: hung",
        "1.4 midpoint_step, or what it steps: wrong: with 64 steps the state is no longer finite",
        "10.3 energy_drift: hung", "Of your functions, these do not pass"})
    CHECK_MESSAGE(contains(result.output, part), result.output);
  CHECK(curve_of(student.numbers(), 0, "RK4").at("right") == true);
}
